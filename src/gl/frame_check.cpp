// What a frame brings along, checked before anything runs.
#include "gl/view.h"

#include "core/base/arguments.h"
#include "core/base/error.h"

#include <algorithm>
#include <iterator>

namespace agaa::gl {

namespace {

// Formats that image stores of floats take (OpenGL 4.3, table 8.26).
constexpr GLenum outputFormats[] = {GL_RGBA32F, GL_RGBA16F, GL_R11F_G11F_B10F, GL_RGBA16,
                                    GL_RGB10_A2, GL_RGBA8};

GLint levelParameter(const GladGLContext& gl, GLuint texture, GLenum parameter) {
    GLint value = 0;
    gl.GetTextureLevelParameteriv(texture, 0, parameter, &value);
    return value;
}

// Mesa does not tell a texture's target in compatibility contexts, so it is bound to that: what is bound there
// now comes back. A texture of another target is an error that is not the host's to find; errors of the host's own
// that come with it are told, but for one of the same kind, which is not to be told from it.
bool isOfTarget(const Context& context, GLuint texture, GLenum target) {
    const GladGLContext& gl = context.gl;
    GLint before = 0, bound = 0;
    const GLenum binding =
        target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_2D_ARRAY;
    gl.GetIntegerv(binding, &before);
    gl.BindTexture(target, texture);
    gl.GetIntegerv(binding, &bound);
    if (GLuint(bound) != texture)
        context.takeHostErrors("agaaGlRecordFrame", GL_INVALID_OPERATION);
    gl.BindTexture(target, GLuint(before));
    return GLuint(bound) == texture;
}

void checkTexture(const Context& context, GLuint texture, GLenum target, const std::string& name,
                  const char* targetName) {
    if (texture == 0 || !context.gl.IsTexture(texture))
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s is not a texture.", name.c_str()));
    if (!isOfTarget(context, texture, target))
        fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s is not a %s.", name.c_str(), targetName));
}

} // namespace

// Programs cannot be changed meanwhile, so every pass would fail.
void View::checkContextState() const {
    GLboolean isActive = GL_FALSE, isPaused = GL_FALSE;
    context.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &isActive);
    context.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &isPaused);
    require(!isActive || isPaused, AGAA_ERROR_WRONG_ORDER,
            "transform feedback is active; pause or end it before the frame.");
}

GLenum View::checkTarget(const AgaaFrame& frame, const AgaaGlFrame& glFrame) const {
    checkReserved(glFrame.reserved, "AgaaGlFrame::reserved");
    if (!(frame.segments & AGAA_SEGMENT_SHADING))
        return GL_NONE;
    const GladGLContext& gl = context.gl;
    require(plan.view.composite || frame.background[3] != 0.0f, AGAA_ERROR_OUT_OF_RANGE,
            "the frame composites over the output, but the view has no AGAA_VIEW_COMPOSITE.");
    const GLuint output = glFrame.outputTexture;
    checkTexture(context, output, GL_TEXTURE_2D, "AgaaGlFrame::outputTexture", "TEXTURE_2D");
    const GLint width = levelParameter(gl, output, GL_TEXTURE_WIDTH);
    const GLint height = levelParameter(gl, output, GL_TEXTURE_HEIGHT);
    if (uint32_t(width) != plan.view.width || uint32_t(height) != plan.view.height)
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("AgaaGlFrame::outputTexture is %dx%d; the view is %ux%u.", width, height, plan.view.width,
                    plan.view.height));
    const auto texels = GLenum(levelParameter(gl, output, GL_TEXTURE_INTERNAL_FORMAT));
    require(std::find(std::begin(outputFormats), std::end(outputFormats), texels) !=
                std::end(outputFormats),
            AGAA_ERROR_UNSUPPORTED,
            "AgaaGlFrame::outputTexture is of a format that images cannot store, as RGBA16F can.");
    for (const Resource& resource : plan.resources) {
        if (resource.kind != ResourceKind::ShadowMap || resource.hostSlot >= frame.shadowCount)
            continue;
        const GLuint map = glFrame.shadowTextures[resource.hostSlot];
        const std::string name = format("AgaaGlFrame::shadowTextures[%u]", resource.hostSlot);
        checkTexture(context, map, GL_TEXTURE_2D_ARRAY, name, "TEXTURE_2D_ARRAY");
        // Comparing with anything else is undefined.
        if (levelParameter(gl, map, GL_TEXTURE_DEPTH_SIZE) == 0)
            fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s holds no depth.", name.c_str()));
    }
    return texels;
}

} // namespace agaa::gl
