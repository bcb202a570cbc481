// Device features by the names that the SDK's requirements give: members of Vulkan's structs.
#pragma once

#include <vulkan/vulkan.h>

#include <string_view>

namespace harness::vk {

// The chain of feature structs that a device of the given API version supports.
class FeatureChain {
public:
    // Flags of enabled extensions. The first two matter only for versions before the one that made them core.
    struct Extensions {
        bool dynamicRendering = false, synchronization2 = false, conditionalRendering = false, interlock = false,
             attachmentOrder = false, coverageReduction = false;
    };
    FeatureChain(uint32_t apiVersion, const Extensions& has);
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;

    // Reads the features that the device supports, for isSet().
    void query(VkPhysicalDevice device);
    // Returns false for names that are unknown here or in this version of the API.
    bool isSet(std::string_view name) const;
    bool set(std::string_view name);
    const void* chain() const { return &core_; }

private:
    const VkBool32* find(std::string_view name) const;

    VkPhysicalDeviceFeatures2 core_{};
    VkPhysicalDeviceVulkan11Features v11_{};
    VkPhysicalDeviceVulkan12Features v12_{};
    VkPhysicalDeviceVulkan13Features v13_{};
    VkPhysicalDeviceDynamicRenderingFeatures dynamicRendering_{};
    VkPhysicalDeviceSynchronization2Features synchronization2_{};
    VkPhysicalDeviceConditionalRenderingFeaturesEXT conditionalRendering_{};
    VkPhysicalDeviceFragmentShaderInterlockFeaturesEXT interlock_{};
    VkPhysicalDeviceRasterizationOrderAttachmentAccessFeaturesEXT attachmentOrder_{};
    VkPhysicalDeviceCoverageReductionModeFeaturesNV coverageReduction_{};
    bool hasV13_ = false;
};

} // namespace harness::vk
