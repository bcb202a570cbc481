// The sample engine's Vulkan instance, device and queue, with the features and extensions of the SDK.
#pragma once

#include "agaa_vk.h"
#include "render/renderer.h"
#include "vk/check.h"
#include "vk/features.h"
#include "vk/messenger.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace harness::vk {

class Device {
public:
    explicit Device(const RendererOptions& options);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physicalDevice() const { return physicalDevice_; }
    VkDevice get() const { return device_; }
    uint32_t queueFamily() const { return queueFamily_; }
    uint32_t apiVersion() const { return apiVersion_; }
    const std::vector<const char*>& extensions() const { return extensions_; }
    const void* features() const { return enabled_->chain(); } // VkPhysicalDeviceFeatures2 of the enabled features
    const VkPhysicalDeviceMemoryProperties& memory() const { return memory_; }
    const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }
    std::string name() const { return properties_.deviceName; }
    bool hasDynamicRendering() const { return hasDynamicRendering_; }
    bool hasValidation() const { return hasValidation_; } // with synchronisation validation
    bool hasAnisotropy() const { return hasAnisotropy_; }
    bool hasPrimitiveIds() const { return hasPrimitiveIds_; }
    std::vector<ApiMessage> takeMessages() { return messages_.take(); }

    // Records commands, submits them and waits.
    void runCommands(const std::function<void(VkCommandBuffer)>& record) const;
    // These functions do the same in steps.
    VkCommandBuffer beginCommands() const;
    // Ends, submits and frees the command buffer. Returns the milliseconds from the submission to the fence.
    double submitAndWait(VkCommandBuffer commands) const;
    void discardCommands(VkCommandBuffer commands) const; // frees the command buffer without submitting it

    // The callback for AgaaVkDeviceDesc.
    static AgaaVkFunction AGAA_CALL getProcAddr(void* instance, const char* name);

private:
    void createInstance(bool useValidation);
    void choosePhysicalDevice();
    void createDevice(const RendererOptions& options);
    void destroy();

    MessageCollector messages_;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice_ = VK_NULL_HANDLE;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    CommandPool commandPool_;
    Fence fence_;
    uint32_t instanceVersion_ = 0;
    uint32_t apiVersion_ = 0;
    uint32_t queueFamily_ = 0;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    std::vector<const char*> extensions_;
    std::optional<FeatureChain> enabled_;
    bool hasDynamicRendering_ = false;
    bool hasAnisotropy_ = false;
    bool hasPrimitiveIds_ = false; // fragment shaders read gl_PrimitiveID
    bool hasValidation_ = false;
};

} // namespace harness::vk
