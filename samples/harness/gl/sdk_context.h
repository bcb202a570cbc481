// The SDK's context and views on OpenGL, with its errors as exceptions.
#pragma once

#include "gl/device.h"
#include "render/sdk_views.h"

#include <optional>

namespace harness::gl {

using GlSdkView = SdkView<DrawPass<AgaaGlDrawPass>>;

// Binding points for the SDK, which the engine's camera and materials do not use.
constexpr uint32_t sdkConstantsUnit = 9;                                                // for AGAA_GL_CONSTANTS_TEXELS
constexpr uint32_t sdkBindings[AGAA_GL_BINDING_COUNT] = {0, 4, 2, 3, 5, 5, 6, 7, 8, 6}; // indexed by AgaaGlBinding

class SdkContext {
public:
    SdkContext(const Device& device, const RendererOptions& options);
    ~SdkContext();
    SdkContext(const SdkContext&) = delete;
    SdkContext& operator=(const SdkContext&) = delete;

    const AgaaDeviceCaps& caps() const { return caps_; }
    SdkLog& log() { return log_; }
    const GlSdkView& view(const AgaaViewDesc& desc); // see SdkViews::get

private:
    SdkLog log_;
    AgaaContext context_ = nullptr;
    AgaaDeviceCaps caps_ = AGAA_DEVICE_CAPS_INIT;
    std::optional<SdkViews<DrawPass<AgaaGlDrawPass>>> views_;
};

} // namespace harness::gl
