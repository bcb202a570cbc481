#include "gl/sdk_context.h"

namespace harness::gl {

namespace {

// The callbacks of AGAA_GL_STATE_CALLBACKS. The sample engine sets all state before each use, so nothing is saved. Only
// the SDK's objects must not stay bound.
AgaaResult AGAA_CALL pushState(void*) { return AGAA_OK; }

AgaaResult AGAA_CALL popState(void* user) {
    const GladGLContext& gl = static_cast<const Device*>(user)->gl();
    gl.UseProgram(0);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return AGAA_OK;
}

} // namespace

SdkContext::SdkContext(const Device& device, const RendererOptions& options) {
    const AgaaLog log = log_.log();
    device.makeCurrent();
    AgaaGlDeviceDesc desc = AGAA_GL_DEVICE_DESC_INIT;
    desc.getProcAddr = Device::getProcAddr;
    desc.glslVersion = options.glslVersion;
    desc.storage = options.storageImages ? AGAA_GL_STORAGE_IMAGES : AGAA_GL_STORAGE_BUFFERS;
    desc.constants = options.constants;
    desc.outputs = options.hostOutputs ? AGAA_GL_OUTPUTS_HOST : AGAA_GL_OUTPUTS_SDK;
    desc.statePolicy = options.statePolicy;
    if (options.statePolicy == AGAA_GL_STATE_CALLBACKS) {
        desc.pushState = pushState;
        desc.popState = popState;
        desc.stateUser = const_cast<Device*>(&device);
    }
    std::copy(std::begin(sdkBindings), std::end(sdkBindings), desc.bindings);
    if (options.constants == AGAA_GL_CONSTANTS_TEXELS)
        desc.bindings[AGAA_GL_BINDING_FRAME] = sdkConstantsUnit;
    AgaaContextDesc common = AGAA_CONTEXT_DESC_INIT;
    common.pNext = &desc;
    common.log = &log;
    log_.check(agaaGlCreateContext(AGAA_HEADER_VERSION, &common, &context_), "agaaGlCreateContext");
    log_.check(agaaGlGetContextCaps(context_, &caps_), "agaaGlGetContextCaps");
    views_.emplace(options.keptViews);
}

SdkContext::~SdkContext() {
    views_.reset();
    agaaDestroyContext(context_);
}

const GlSdkView& SdkContext::view(const AgaaViewDesc& desc) {
    const auto create = [this](const AgaaViewDesc& wanted) {
        AgaaView view = nullptr;
        log_.check(agaaGlCreateView(context_, &wanted, &view), "agaaGlCreateView");
        return view;
    };
    const auto list = [this](AgaaView view) {
        return drawPassesOf(view, AgaaGlDrawPass AGAA_GL_DRAW_PASS_INIT,
                            [this](AgaaResult result) { log_.check(result, "agaaGetDrawPasses"); });
    };
    return views_->get(desc, create, list);
}

} // namespace harness::gl
