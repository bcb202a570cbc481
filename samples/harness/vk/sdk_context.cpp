#include "vk/sdk_context.h"

#include <cstring>

namespace harness::vk {

namespace {

VKAPI_ATTR void VKAPI_CALL formatPropertiesWithoutD24(VkPhysicalDevice device, VkFormat format,
                                                      VkFormatProperties* properties) {
    vkGetPhysicalDeviceFormatProperties(device, format, properties);
    if (format == VK_FORMAT_D24_UNORM_S8_UINT)
        *properties = {};
}

AgaaVkFunction AGAA_CALL getProcAddrWithoutD24(void* instance, const char* name) {
    if (std::strcmp(name, "vkGetPhysicalDeviceFormatProperties") == 0)
        return reinterpret_cast<AgaaVkFunction>(formatPropertiesWithoutD24);
    return Device::getProcAddr(instance, name);
}

} // namespace

SdkContext::SdkContext(const Device& device, const RendererOptions& options, uint32_t descriptorSet) {
    createContext(device, options, descriptorSet);
    views_.emplace(options.keptViews);
}

void SdkContext::createContext(const Device& device, const RendererOptions& options, uint32_t descriptorSet) {
    const AgaaLog log = log_.log();
    const auto getProcAddr = options.noD24 ? getProcAddrWithoutD24 : Device::getProcAddr;
    log_.check(agaaVkGetDeviceCaps(device.instance(), device.physicalDevice(), getProcAddr, &log, &caps_),
               "agaaVkGetDeviceCaps");
    AgaaVkDeviceDesc desc = AGAA_VK_DEVICE_DESC_INIT;
    desc.instance = device.instance();
    desc.physicalDevice = device.physicalDevice();
    desc.device = device.get();
    desc.queueFamily = device.queueFamily();
    desc.apiVersion = device.apiVersion();
    desc.getProcAddr = getProcAddr;
    desc.enabledExtensions = device.extensions().data();
    desc.enabledExtensionCount = uint32_t(device.extensions().size());
    desc.enabledFeatures = device.features();
    desc.rendering = options.renderPass ? AGAA_VK_RENDERING_RENDER_PASS : AGAA_VK_RENDERING_AUTO;
    desc.recording = options.inlineRecording ? AGAA_VK_RECORDING_INLINE : AGAA_VK_RECORDING_SECONDARY;
    desc.descriptorSet = descriptorSet;
    AgaaContextDesc common = AGAA_CONTEXT_DESC_INIT;
    common.pNext = &desc;
    common.log = &log;
    log_.check(agaaVkCreateContext(AGAA_HEADER_VERSION, &common, &context_), "agaaVkCreateContext");
    // The capabilities of the context exclude features that were not enabled.
    log_.check(agaaVkGetContextCaps(context_, &caps_), "agaaVkGetContextCaps");
}

SdkContext::~SdkContext() {
    views_.reset();
    agaaDestroyContext(context_);
}

const VkSdkView& SdkContext::view(const AgaaViewDesc& desc) {
    const auto create = [this](const AgaaViewDesc& wanted) {
        AgaaView view = nullptr;
        log_.check(agaaVkCreateView(context_, &wanted, &view), "agaaVkCreateView");
        return view;
    };
    const auto list = [this](AgaaView view) {
        return drawPassesOf(view, AgaaVkDrawPass AGAA_VK_DRAW_PASS_INIT,
                            [this](AgaaResult result) { log_.check(result, "agaaGetDrawPasses"); });
    };
    return views_->get(desc, create, list);
}

} // namespace harness::vk
