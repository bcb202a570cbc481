// Runs a frame: checks it, then runs the passes of its segments. The host's state is restored around draw callbacks.
#include "core/base/error.h"
#include "core/frame/frame_checks.h"
#include "core/frame/frame_data.h"
#include "gl/bindings.h"
#include "gl/formats.h"
#include "gl/host_state.h"
#include "gl/output_view.h"

#include <algorithm>
#include <list>
#include <optional>
#include <set>
#include <span>

namespace agaa::gl {

void View::clearColor(size_t pass) const {
    constexpr GLuint zero[4] = {};
    GLint attachment = 0;
    for (const ColorAttachment& color : hostPasses[pass].colors) {
        if (isInteger(color.format)) // always cleared to 0
            context.gl.ClearNamedFramebufferuiv(framebuffers[pass], GL_COLOR, attachment, zero);
        else
            context.gl.ClearNamedFramebufferfv(framebuffers[pass], GL_COLOR, attachment, color.clear.data());
        ++attachment;
    }
}

// Clears obey masks, the scissor test and the discarding of primitives.
void View::clearTargets(size_t index) {
    const Pass& pass = plan.passes[index];
    const Format depth = hostPasses[index].depthFormat;
    const GladGLContext& gl = context.gl;
    gl.Disablei(GL_SCISSOR_TEST, 0);
    gl.Disable(GL_RASTERIZER_DISCARD);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.DepthMask(GL_TRUE);
    gl.StencilMask(~0u);
    if (pass.draw().clearsColor)
        clearColor(index);
    if (!pass.draw().clearsDepth || depth == Format::None)
        return;
    if (hasStencil(depth))
        gl.ClearNamedFramebufferfi(framebuffers[index], GL_DEPTH_STENCIL, 0, pass.draw().clear.depth,
                                   GLint(pass.draw().clear.stencil));
    else
        gl.ClearNamedFramebufferfv(framebuffers[index], GL_DEPTH, 0, &pass.draw().clear.depth);
}

// Returns the map's texture. If the frame lacks the map, any valid texture is bound: shaders declare it but do not read
// it. Textures beyond the frame's shadow maps were not checked and are never used.
GLuint View::shadowTexture(const Resource& map, const AgaaFrame& frame, const AgaaGlFrame& glFrame) const {
    const auto textureOf = [&](const Resource& resource) {
        return resource.hostSlot < frame.shadowCount ? glFrame.shadowTextures[resource.hostSlot] : 0u;
    };
    if (textureOf(map))
        return textureOf(map);
    for (const Resource& resource : plan.resources)
        if (resource.kind == ResourceKind::ShadowMap && textureOf(resource))
            return textureOf(resource);
    return context.emptyShadowMap;
}

// Binds the frame constants for a draw callback.
void View::bindConstants(GLuint point, ResourceId resource, uint32_t slot) {
    const GladGLContext& gl = context.gl;
    if (context.dialect.constants == AGAA_GL_CONSTANTS_BLOCK)
        gl.BindBufferBase(GL_UNIFORM_BUFFER, point, resources->buffer(resource, slot));
    if (context.dialect.constants != AGAA_GL_CONSTANTS_TEXELS)
        return;
    gl.BindTextureUnit(point, resources->bufferImage(resource, slot));
    gl.BindSampler(point, 0);
}

void View::bindForHost(const Pass& pass, const AgaaFrame& frame, const AgaaGlFrame& glFrame, uint32_t slot) {
    const GladGLContext& gl = context.gl;
    GLint uniformBuffer = 0, storageBuffer = 0;
    const bool restoresTargets = context.statePolicy != AGAA_GL_STATE_NONE;
    // glBindBufferBase also binds to the target, where the host's buffer must remain. AGAA_GL_STATE_NONE skips the
    // queries: drivers with a thread of their own synchronise at each of them.
    if (restoresTargets) {
        gl.GetIntegerv(GL_UNIFORM_BUFFER_BINDING, &uniformBuffer);
        gl.GetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &storageBuffer);
    }
    for (const Binding& binding : pass.bindings) {
        const GLuint point = context.dialect.bindings[binding.slot];
        switch (binding.type) {
        case BindingType::UniformBuffer:
            bindConstants(point, binding.resource, slot);
            break;
        case BindingType::StorageBuffer:
            if (hostKind(hostBindingTable[binding.slot], context.dialect) == BindingKind::Image)
                gl.BindImageTexture(point, resources->bufferImage(binding.resource, slot), 0, GL_FALSE, 0,
                                    GL_READ_WRITE, GL_R32UI);
            else
                gl.BindBufferBase(context.dialect.storageImages ? GL_UNIFORM_BUFFER : GL_SHADER_STORAGE_BUFFER, point,
                                  resources->buffer(binding.resource, slot));
            break;
        case BindingType::ShadowTexture:
            gl.BindTextureUnit(point, shadowTexture(plan.resources[binding.resource], frame, glFrame));
            gl.BindSampler(point, context.shadowSampler);
            break;
        case BindingType::Texture:
        case BindingType::StorageImage:
            gl.BindTextureUnit(point, (*resources)[binding.resource].texture);
            gl.BindSampler(point, 0);
            break;
        }
    }
    if (!restoresTargets)
        return;
    gl.BindBuffer(GL_UNIFORM_BUFFER, GLuint(uniformBuffer));
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, GLuint(storageBuffer));
}

void View::runHostDraw(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Step& step, uint32_t slot,
                       HostState& state) {
    const Pass& pass = plan.passes[step.pass];
    if (pass.draw().clearsColor || pass.draw().clearsDepth)
        clearTargets(step.pass);
    AgaaDrawTarget target = drawTarget(plan, step, hostPasses[step.pass], extentOf(frame, plan));
    target.framebuffer = framebuffers[step.pass];
    std::vector<float> constants;
    if (context.dialect.constants == AGAA_GL_CONSTANTS_UNIFORMS) {
        constants = uniformConstants(plan, frameConstants(plan, frame, positions));
        target.constants = constants.data();
        target.constantCount = uint32_t(constants.size() / 4);
    }
    state.restore();
    if (context.hostBindings)
        context.hostBindings->capture();
    bindForHost(pass, frame, glFrame, slot);
    const AgaaResult result = callDraw(plan, pass, frame, target);
    if (context.hostBindings)
        context.hostBindings->restore();
    if (result != AGAA_OK)
        failDraw(AGAA_ERROR_CALLBACK, result, pass, "the output was not written");
    state.save();
    if (target.state.sampleLocations && target.state.depthWrite)
        evaluateDepth(step.pass);
}

// Drivers may keep planes in place of depths and evaluate them at the default locations when shaders read the texture.
// The scissor of the host's last layer would leave out the others.
void View::evaluateDepth(size_t pass) {
    const GladGLContext& gl = context.gl;
    gl.Disablei(GL_SCISSOR_TEST, 0);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[pass]);
    gl.EvaluateDepthValuesARB();
}

void View::bindForCompute(const Pass& pass, const AgaaFrame& frame, const AgaaGlFrame& glFrame, uint32_t slot) {
    const GladGLContext& gl = context.gl;
    for (const Binding& binding : pass.bindings) {
        const Resource& resource = plan.resources[binding.resource];
        const bool output = resource.kind == ResourceKind::Output;
        const GLuint point = bindingPointOf(binding.slot);
        const GLuint texture = output ? outputs_[resource.hostSlot].texture : (*resources)[binding.resource].texture;
        switch (binding.type) {
        case BindingType::UniformBuffer:
            gl.BindBufferBase(GL_UNIFORM_BUFFER, point, resources->buffer(binding.resource, slot));
            break;
        case BindingType::StorageBuffer:
            gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, point, resources->buffer(binding.resource, slot));
            break;
        case BindingType::StorageImage:
            gl.BindImageTexture(point, texture, 0, GL_FALSE, 0, GL_WRITE_ONLY,
                                output ? outputs_[resource.hostSlot].format : internalFormat(resource.format));
            break;
        case BindingType::Texture:
            gl.BindTextureUnit(point, texture);
            gl.BindSampler(point, binding.filter == Filter::Linear ? context.linearSampler
                                  : output                         ? context.texelSampler
                                                                   : 0);
            break;
        case BindingType::ShadowTexture:
            gl.BindTextureUnit(point, shadowTexture(resource, frame, glFrame));
            gl.BindSampler(point, context.shadowSampler);
            break;
        }
    }
}

void View::runTransfer(const Pass& pass, uint64_t frameIndex, uint32_t slot) {
    const GladGLContext& gl = context.gl;
    if (pass.kind() == PassKind::Fill) {
        const FillPart& fill = pass.fill();
        const GLuint buffer = resources->buffer(fill.destination, slot);
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, context.emptyFramebuffer);
        context.bufferFill->fill(buffer, fill.bytes ? fill.bytes : plan.resources[fill.destination].bytes, fill.value);
        const uint32_t stamp = stampOf(frameIndex);
        if (fill.stampOffset != noStamp)
            gl.NamedBufferSubData(buffer, GLintptr(fill.stampOffset), sizeof stamp, &stamp);
    } else
        gl.CopyNamedBufferSubData(resources->buffer(pass.copy().source, slot),
                                  resources->buffer(pass.copy().destination, slot), 0, 0,
                                  GLsizeiptr(plan.bytesOf(pass.copy())));
}

// Returns the textures of the host that the pass uses, each once.
static std::set<GLuint> outputsOf(const Plan& plan, const Pass& pass, std::span<const OutputTexture> outputs) {
    std::set<GLuint> textures;
    for (const Binding& binding : pass.bindings)
        if (plan.resources[binding.resource].kind == ResourceKind::Output)
            textures.insert(outputs[plan.resources[binding.resource].hostSlot].texture);
    return textures;
}

void View::dispatch(const Dispatch& dispatch, FrameExtent extent, uint32_t slot) {
    const GladGLContext& gl = context.gl;
    if (dispatch.kind == DispatchKind::Indirect) {
        gl.BindBuffer(GL_DISPATCH_INDIRECT_BUFFER, resources->buffer(dispatch.arguments, slot));
        gl.DispatchComputeIndirect(GLintptr(dispatch.argumentsOffset));
        return;
    }
    const auto [x, y] = plan.groups(dispatch, extent);
    gl.DispatchCompute(x, y, 1);
}

void View::writeBreadcrumb(uint64_t offset, const Breadcrumb& crumb) const {
    context.gl.ClearNamedBufferSubData(resources->buffer(plan.breadcrumbs, 0), GL_RGBA32UI, GLintptr(offset),
                                       sizeof crumb, GL_RGBA_INTEGER, GL_UNSIGNED_INT, &crumb);
}

void View::runStep(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Variant& variant, size_t number,
                   uint32_t slot, HostState& state) {
    const Step& step = steps[number];
    const size_t index = step.pass;
    const Pass& pass = plan.passes[index];
    const GladGLContext& gl = context.gl;
    if (const GLbitfield bits = barriers.before(plan, pass, context.dialect.storageImages))
        gl.MemoryBarrier(bits);
    // This precedes the pass because the stores of a draw whose callback then fails need barriers too.
    barriers.after(plan, pass);
    const Breadcrumb crumb{frame.frameIndex, step.pass, step.batch};
    if (plan.breadcrumbs != noResource)
        writeBreadcrumb(offsetof(BreadcrumbBuffer, begun), crumb);
    if (clock)
        clock->begin(slot, number);
    switch (pass.kind()) {
    case PassKind::HostDraw:
        runHostDraw(frame, glFrame, step, slot, state);
        break;
    case PassKind::Compute: {
        std::list<OutputView> views;
        for (const GLuint texture : outputsOf(plan, pass, outputs_))
            views.emplace_back(gl, texture);
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, context.emptyFramebuffer);
        gl.UseProgram(GLuint(variant.programs[index]));
        bindForCompute(pass, frame, glFrame, slot);
        dispatch(pass.compute().dispatch, extentOf(frame, plan), slot);
        break;
    }
    case PassKind::Fill:
    case PassKind::Copy:
        runTransfer(pass, frame.frameIndex, slot);
        break;
    }
    if (clock)
        clock->end(slot, number);
    if (plan.breadcrumbs == noResource)
        return;
    gl.MemoryBarrier(GL_ALL_BARRIER_BITS); // the pass ends before the write
    writeBreadcrumb(offsetof(BreadcrumbBuffer, ended), crumb);
}

namespace {

// Groups the calls of a pass in captures of the host. The scope ends the group.
class DebugGroup {
public:
    DebugGroup(const GladGLContext& gl, const std::string& text) : gl_(gl) {
        gl.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, GLsizei(text.size()), text.c_str());
    }
    ~DebugGroup() { gl_.PopDebugGroup(); }
    DebugGroup(const DebugGroup&) = delete;
    DebugGroup& operator=(const DebugGroup&) = delete;

private:
    const GladGLContext& gl_;
};

} // namespace

// Returns whether the host draws in the repetition of this pass.
static bool repeatsDraws(const Plan& plan, uint32_t pass) {
    return std::ranges::any_of(plan.repeats, [&](const Repeat& repeat) {
        const auto range = std::span(plan.passes).subspan(repeat.firstPass, repeat.lastPass - repeat.firstPass + 1);
        return pass >= repeat.firstPass && pass <= repeat.lastPass &&
               std::ranges::any_of(range, [](const Pass& p) { return p.kind() == PassKind::HostDraw; });
    });
}

// Returns whether the step and the rest of its repetition have nothing to do. Waits for the device, except in a
// repetition of dispatches alone, which find out by themselves.
bool View::isFinished(const Step& step, uint32_t slot) const {
    if (!step.hasPredicate() || !repeatsDraws(plan, step.pass))
        return false;
    context.gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    uint32_t predicate = 0;
    readBuffer(step.predicateBuffer, slot, step.predicateOffset, std::as_writable_bytes(std::span(&predicate, 1)));
    return predicate != 0;
}

void View::runPasses(const AgaaFrame& frame, const AgaaGlFrame& glFrame, const Variant& variant, uint32_t slot,
                     HostState& state) {
    GLint groups = 0;
    context.gl.GetIntegerv(GL_DEBUG_GROUP_STACK_DEPTH, &groups);
    uint32_t batch = 0;
    bool isRepetitionFinished = false;
    for (size_t number = 0; number < steps.size(); ++number) {
        const Step& step = steps[number];
        const Pass& pass = plan.passes[step.pass];
        if (!(pass.segment & frame.segments))
            continue;
        // The last pass of a batch alone changes the predicate, so that one read per batch suffices.
        if (step.batch == 0)
            isRepetitionFinished = false;
        else if (step.batch != batch && !isRepetitionFinished)
            isRepetitionFinished = isFinished(step, slot);
        batch = step.batch;
        if (isRepetitionFinished) {
            if (clock)
                clock->skip(slot, number);
            continue;
        }
        std::optional<DebugGroup> group;
        if (groups < context.maxDebugGroups)
            group.emplace(context.gl, "agaa " + pass.name);
        runStep(frame, glFrame, variant, number, slot, state);
    }
    // The host may use the contents that the segment wrote in any way.
    context.gl.MemoryBarrier(GL_ALL_BARRIER_BITS);
}

AgaaResult View::record(AgaaFrame frame, const AgaaGlFrame& glFrame) {
    AgaaSceneFacts facts;
    const bool isPlaced = frame.width != 0;
    checkFrame(frame, facts);
    context.requireAlive();
    try {
        checkContextState();
        checkTarget(frame, glFrame, isPlaced);
    } catch (...) {
        context.requireAlive(); // queries of a context that was lost meanwhile leave values of a wrong object
        throw;
    }
    const uint32_t slot = sequence.slotOf(frame);
    const Variant& variant = variantOf(frame);
    HostState state(context); // if it throws, no pass has run
    try {
        uploadFrame(frame, slot);
        if (sequence.changesSize(frame)) {
            context.gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT); // stores of a frame that failed
            resources->clearPersistent(plan);
        }
        runPasses(frame, glFrame, variant, slot, state);
        state.finish();
    } catch (...) {
        sequence.abortedAfterExecution(frame);
        throw;
    }
    recorded(frame);
    return AGAA_OK;
}

} // namespace agaa::gl
