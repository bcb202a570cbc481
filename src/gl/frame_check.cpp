// Checks of a frame's OpenGL objects and of the context before any pass runs.
#include "core/base/arguments.h"
#include "core/base/error.h"
#include "core/frame/frame_checks.h"
#include "gl/structs.h"
#include "gl/view.h"

#include <algorithm>
#include <iterator>
#include <span>

namespace agaa::gl {

namespace {

// Floating-point and normalised formats that support image stores (OpenGL 4.3, table 8.26).
constexpr GLenum outputFormats[] = {GL_RGBA32F, GL_RGBA16F, GL_R11F_G11F_B10F, GL_RGBA16, GL_RGB10_A2, GL_RGBA8};
// Further ones for single values.
constexpr GLenum valueFormats[] = {GL_RG32F,     GL_RG16F,    GL_R32F,         GL_R16F,       GL_RG16,
                                   GL_RG8,       GL_R16,      GL_R8,           GL_RG16_SNORM, GL_RG8_SNORM,
                                   GL_R16_SNORM, GL_R8_SNORM, GL_RGBA16_SNORM, GL_RGBA8_SNORM};

bool isIn(std::span<const GLenum> formats, GLenum format) { return std::ranges::count(formats, format) != 0; }

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

// Checks the textures of the resolved outputs. right, top: the end of the frame in them.
void View::checkResolved(const AgaaGlFrame& glFrame, uint64_t right, uint64_t top) {
    const size_t count = plan.view.resolvedOutputs.size();
    if (count == 0)
        return;
    const std::optional<AgaaGlResolvedTextures> resolved = readChained<AgaaGlResolvedTextures>(&glFrame);
    require(resolved.has_value(), AGAA_ERROR_INVALID_ARGUMENT,
            "the view has AgaaResolvedOutputs, and AgaaGlFrame chains no AgaaGlResolvedTextures.");
    checkReserved(resolved->reserved[0] | resolved->reserved[1], "AgaaGlResolvedTextures::reserved");
    const GladGLContext& gl = context.gl;
    for (size_t i = 0; i < count; ++i) {
        const GLuint texture = resolved->textures[i];
        const std::string name = format("AgaaGlResolvedTextures::textures[%zu]", i);
        checkTexture(context, texture, GL_TEXTURE_2D, name, "TEXTURE_2D");
        const GLint width = levelParameter(gl, texture, GL_TEXTURE_WIDTH);
        const GLint height = levelParameter(gl, texture, GL_TEXTURE_HEIGHT);
        if (uint64_t(width) < right || uint64_t(height) < top)
            fail(AGAA_ERROR_OUT_OF_RANGE,
                 format("%s is %dx%d; the frame ends at %llu, %llu.", name.c_str(), width, height,
                        static_cast<unsigned long long>(right), static_cast<unsigned long long>(top)));
        const auto texels = GLenum(levelParameter(gl, texture, GL_TEXTURE_INTERNAL_FORMAT));
        if (!isIn(outputFormats, texels) && !isIn(valueFormats, texels))
            fail(AGAA_ERROR_UNSUPPORTED,
                 format("%s is of a format that images cannot store, as R32F can.", name.c_str()));
        require(std::none_of(outputs_.begin(), outputs_.begin() + long(i) + 1,
                             [&](const OutputTexture& other) { return other.texture == texture; }),
                AGAA_ERROR_INVALID_ARGUMENT, "AgaaGlResolvedTextures has a texture twice, or the output.");
        outputs_[i + 1] = {texture, texels};
    }
}

void View::checkTarget(const AgaaFrame& frame, const AgaaGlFrame& glFrame, bool isPlaced) {
    checkReserved(glFrame.reserved, "AgaaGlFrame::reserved");
    if (!(frame.segments & AGAA_SEGMENT_SHADING))
        return;
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
    require(isIn(outputFormats, texels), AGAA_ERROR_UNSUPPORTED,
            "AgaaGlFrame::outputTexture is of a format that images cannot store, as RGBA16F can.");
    outputs_[0] = {output, texels};
    const FrameExtent extent = extentOf(frame, plan);
    checkResolved(glFrame, uint64_t(frame.outputX) + extent.width, uint64_t(frame.outputY) + extent.height);
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
}

} // namespace agaa::gl
