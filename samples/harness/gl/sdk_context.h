// The SDK's context and views on OpenGL, with its errors as exceptions.
#pragma once

#include "gl/device.h"
#include "render/sdk_views.h"

#include <optional>

namespace harness::gl {

using GlSdkView = SdkView<AgaaGlDrawPass>;

// Where the engine lets the SDK bind: beside its own camera and materials.
constexpr uint32_t frameBinding = 0;
constexpr uint32_t metadataUnit = 4;
constexpr uint32_t aggregatesBinding = 2;
constexpr uint32_t countersBinding = 3;
constexpr uint32_t lightsBinding = 5;
constexpr uint32_t shadowUnit = 5;

class SdkContext {
public:
    SdkContext(const Device& device, const RendererOptions& options);
    ~SdkContext();
    SdkContext(const SdkContext&) = delete;
    SdkContext& operator=(const SdkContext&) = delete;

    const AgaaDeviceCaps& caps() const { return caps_; }
    SdkLog& log() { return log_; }
    const GlSdkView& view(const AgaaViewDesc& desc); // as SdkViews::get

private:
    SdkLog log_;
    AgaaContext context_ = nullptr;
    AgaaDeviceCaps caps_ = AGAA_DEVICE_CAPS_INIT;
    std::optional<SdkViews<AgaaGlDrawPass>> views_;
};

} // namespace harness::gl
