// Device features by the names that the SDK's requirements give: members of Vulkan's structs.
#pragma once

#include <vulkan/vulkan.h>

#include <string_view>

namespace harness::vk {

// The chain of feature structs that a device of the given API version knows.
class FeatureChain {
public:
    // hasDynamicRendering, hasSynchronization2: the extensions of these names, where the version is
    // below the one that took them into the core. hasInterlock: VK_EXT_fragment_shader_interlock.
    FeatureChain(uint32_t apiVersion, bool hasDynamicRendering, bool hasSynchronization2, bool hasInterlock);
    FeatureChain(const FeatureChain&) = delete;
    FeatureChain& operator=(const FeatureChain&) = delete;

    // What the device supports, to be asked by isSet().
    void query(VkPhysicalDevice device);
    // False for names that are unknown here, or unknown to a device of this version.
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
    VkPhysicalDeviceFragmentShaderInterlockFeaturesEXT interlock_{};
    bool hasV13_ = false;
};

} // namespace harness::vk
