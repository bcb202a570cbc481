#include "gl/state_context.h"

#include "gl/errors.h"

#include <algorithm>
#include <numeric>

namespace agaa::gl {
namespace {

uint32_t limit(const GladGLContext& gl, GLenum parameter) {
    GLint value = 0;
    gl.GetIntegerv(parameter, &value);
    return static_cast<uint32_t>(std::max(value, 0));
}

std::vector<uint32_t> below(const GladGLContext& gl, GLenum parameter, std::vector<uint32_t> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    points.erase(std::lower_bound(points.begin(), points.end(), limit(gl, parameter)), points.end());
    return points;
}

std::vector<uint32_t> first(uint32_t count) {
    std::vector<uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

} // namespace

StateContext::StateContext(const GladGLContext& gl, const StateScope& scope, bool compatibilityProfile)
    : gl_(gl), compatibility_(compatibilityProfile) {
    const auto set = [&](StateArray array, std::vector<uint32_t> elements) {
        elements_[static_cast<size_t>(array)] = std::move(elements);
    };
    set(StateArray::Once, {0});
    set(StateArray::TextureUnits, below(gl, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, scope.textureUnits));
    set(StateArray::UniformBindings, below(gl, GL_MAX_UNIFORM_BUFFER_BINDINGS, scope.uniformBindings));
    set(StateArray::StorageBindings, below(gl, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, scope.storageBindings));
    set(StateArray::ImageUnits, below(gl, GL_MAX_IMAGE_UNITS, scope.imageUnits));
    // All elements are saved: draw callbacks use the functions without an index (glColorMask, glViewport, …), which set
    // all of them.
    set(StateArray::DrawBuffers, first(limit(gl, GL_MAX_DRAW_BUFFERS)));
    set(StateArray::Viewports, first(limit(gl, GL_MAX_VIEWPORTS)));
    set(StateArray::ClipDistances, first(limit(gl, GL_MAX_CLIP_DISTANCES)));
    set(StateArray::SampleMaskWords, first(limit(gl, GL_MAX_SAMPLE_MASK_WORDS)));

    try {
        createObjects();
    } catch (...) {
        destroyObjects();
        discardErrors(gl);
        throw;
    }
}

StateContext::~StateContext() { destroyObjects(); }

void StateContext::createObjects() {
    gl_.CreateProgramPipelines(1, &pipeline_);
    requireObject(gl_, pipeline_, "glCreateProgramPipelines");
    gl_.CreateRenderbuffers(1, &stencil_);
    gl_.NamedRenderbufferStorage(requireObject(gl_, stencil_, "glCreateRenderbuffers"), GL_DEPTH24_STENCIL8, 1, 1);
    gl_.CreateFramebuffers(1, &framebuffer_);
    requireObject(gl_, framebuffer_, "glCreateFramebuffers");
    gl_.NamedFramebufferRenderbuffer(framebuffer_, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, stencil_);
    // Makes the driver validate the attachment now: binding the framebuffer alone may not.
    gl_.CheckNamedFramebufferStatus(framebuffer_, GL_DRAW_FRAMEBUFFER);
}

void StateContext::destroyObjects() {
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteRenderbuffers(1, &stencil_);
    gl_.DeleteProgramPipelines(1, &pipeline_);
}

bool StateContext::has(const StateRow& row) const {
    if (row.profile == StateProfile::Core && compatibility_)
        return false;
    if (row.profile == StateProfile::Compatibility && !compatibility_)
        return false;
    return row.need.met == nullptr || row.need.met(gl_);
}

StateReading::StateReading(const StateContext& context) : context_(context) {
    gl().GetIntegerv(GL_ACTIVE_TEXTURE, &activeTexture_);
    gl().GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawFramebuffer_);
    gl().BindFramebuffer(GL_DRAW_FRAMEBUFFER, context.framebuffer_);
    if (context.compatibility_) {
        gl().GetIntegerv(GL_CLAMP_FRAGMENT_COLOR, &clampFragmentColor_);
        gl().ClampColor(GL_CLAMP_FRAGMENT_COLOR, GL_FALSE);
    }
}

StateReading::~StateReading() {
    if (context_.compatibility_)
        gl().ClampColor(GL_CLAMP_FRAGMENT_COLOR, static_cast<GLenum>(clampFragmentColor_));
    gl().BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
    gl().ActiveTexture(static_cast<GLenum>(activeTexture_));
}

} // namespace agaa::gl
