// Checks of a frame's OpenGL objects and of the context before any pass runs.
#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/frame/frame_checks.h"
#include "gl/view.h"

#include <algorithm>
#include <iterator>

namespace agaa::gl {

namespace {

// Floating-point and normalised formats that support image stores (OpenGL 4.3, table 8.26).
constexpr GLenum outputFormats[] = {GL_RGBA32F, GL_RGBA16F, GL_R11F_G11F_B10F, GL_RGBA16, GL_RGB10_A2, GL_RGBA8};

GLint levelParameter(const GladGLContext& gl, GLuint texture, GLenum parameter) {
    GLint value = 0;
    gl.GetTextureLevelParameteriv(texture, 0, parameter, &value);
    return value;
}

// Mesa cannot query a texture's target in compatibility contexts, so this function binds the texture to the target and
// then restores the binding. If the texture has another target, OpenGL raises GL_INVALID_OPERATION, which is removed.
// Pending errors of the host are logged, except one GL_INVALID_OPERATION, which cannot be distinguished.
bool isOfTarget(const Context& context, GLuint texture, GLenum target) {
    const GladGLContext& gl = context.gl;
    GLint before = 0, bound = 0;
    const GLenum binding = target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_2D_ARRAY;
    gl.GetIntegerv(binding, &before);
    gl.BindTexture(target, texture);
    gl.GetIntegerv(binding, &bound);
    if (GLuint(bound) != texture)
        context.clearHostErrors("agaaGlRecordFrame", GL_INVALID_OPERATION);
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

// While transform feedback is active, programs cannot be changed and every pass would fail.
void View::checkContextState() const {
    GLboolean isActive = GL_FALSE, isPaused = GL_FALSE;
    context.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_ACTIVE, &isActive);
    context.gl.GetBooleanv(GL_TRANSFORM_FEEDBACK_PAUSED, &isPaused);
    require(!isActive || isPaused, AGAA_ERROR_WRONG_ORDER,
            "transform feedback is active; pause or end it before the frame.");
}

GLenum View::checkTarget(const AgaaFrame& frame, const AgaaGlFrame& glFrame, bool isPlaced) const {
    checkReserved(glFrame.reserved, "AgaaGlFrame::reserved");
    if (!(frame.segments & AGAA_SEGMENT_SHADING))
        return GL_NONE;
    const GladGLContext& gl = context.gl;
    checkComposite(frame, plan);
    const GLuint output = glFrame.outputTexture;
    checkTexture(context, output, GL_TEXTURE_2D, "AgaaGlFrame::outputTexture", "TEXTURE_2D");
    const GLint width = levelParameter(gl, output, GL_TEXTURE_WIDTH);
    const GLint height = levelParameter(gl, output, GL_TEXTURE_HEIGHT);
    const uint64_t right = uint64_t(frame.outputX) + frame.width, top = uint64_t(frame.outputY) + frame.height;
    if (isPlaced && (uint64_t(width) < right || uint64_t(height) < top))
        fail(AGAA_ERROR_OUT_OF_RANGE,
             format("AgaaGlFrame::outputTexture is %dx%d; the frame ends at %llu, %llu.", width, height,
                    static_cast<unsigned long long>(right), static_cast<unsigned long long>(top)));
    if (!isPlaced && (uint32_t(width) != plan.view.width || uint32_t(height) != plan.view.height))
        fail(AGAA_ERROR_OUT_OF_RANGE, format("AgaaGlFrame::outputTexture is %dx%d; the view is %ux%u.", width, height,
                                             plan.view.width, plan.view.height));
    const auto texels = GLenum(levelParameter(gl, output, GL_TEXTURE_INTERNAL_FORMAT));
    require(std::find(std::begin(outputFormats), std::end(outputFormats), texels) != std::end(outputFormats),
            AGAA_ERROR_UNSUPPORTED,
            "AgaaGlFrame::outputTexture is of a format that images cannot store, as RGBA16F can.");
    for (const Resource& resource : plan.resources) {
        if (resource.kind != ResourceKind::ShadowMap || resource.hostSlot >= frame.shadowCount)
            continue;
        const GLuint map = glFrame.shadowTextures[resource.hostSlot];
        const std::string name = format("AgaaGlFrame::shadowTextures[%u]", resource.hostSlot);
        checkTexture(context, map, GL_TEXTURE_2D_ARRAY, name, "TEXTURE_2D_ARRAY");
        // Depth comparison is undefined for textures without depth.
        if (levelParameter(gl, map, GL_TEXTURE_DEPTH_SIZE) == 0)
            fail(AGAA_ERROR_INVALID_ARGUMENT, format("%s holds no depth.", name.c_str()));
    }
    return texels;
}

} // namespace agaa::gl
