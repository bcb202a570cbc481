// Stands between the SDK and Vulkan: functions are missing, too, and devices say other things of themselves.
#pragma once

#include "interposer.h"

#include <vulkan/vulkan.h>

#include <set>

namespace agaa::conformance {

// Once a call failed, all later calls of the same function do.
class VulkanInterposer : public Interposer {
public:
    VulkanInterposer();
    ~VulkanInterposer() override;

    void chainTo(ContextDescription& description) override { description.vk.getProcAddr = getProcAddr; }
    static AgaaVkFunction AGAA_CALL getProcAddr(void* instance, const char* name);

    std::set<std::string> missing; // functions that nobody has
    std::set<std::string> asked;   // functions that the SDK asked for, and that Vulkan has

    // What the device says. Null: nothing is changed.
    std::function<void(VkPhysicalDeviceProperties&)> changeProperties;
    std::function<void(VkQueueFamilyProperties&)> changeQueueFamily; // of each family
    bool hasImageFormats = true; // false: the device supports images of no format

    // For the functions in place of Vulkan's.
    static VulkanInterposer* current;
    bool fails(const char* function, VkResult& error);
};

} // namespace agaa::conformance
