// The SDK's context and views on Vulkan, with its errors as exceptions.
#pragma once

#include "render/sdk_views.h"
#include "vk/device.h"

#include <optional>

namespace harness::vk {

using VkSdkView = SdkView<DrawPass<AgaaVkDrawPass>>;

class SdkContext {
public:
    SdkContext(const Device& device, const RendererOptions& options, uint32_t descriptorSet);
    ~SdkContext();
    SdkContext(const SdkContext&) = delete;
    SdkContext& operator=(const SdkContext&) = delete;

    const AgaaDeviceCaps& caps() const { return caps_; }
    SdkLog& log() { return log_; }

    // Returns a view that stays valid for one further call, because measurements alternate between two views. All
    // frames must have finished.
    const VkSdkView& view(const AgaaViewDesc& desc);

private:
    void createContext(const Device& device, const RendererOptions& options, uint32_t descriptorSet);

    SdkLog log_;
    AgaaContext context_ = nullptr;
    AgaaDeviceCaps caps_ = AGAA_DEVICE_CAPS_INIT;
    std::optional<SdkViews<DrawPass<AgaaVkDrawPass>>> views_;
};

} // namespace harness::vk
