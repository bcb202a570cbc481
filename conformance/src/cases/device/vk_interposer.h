// Stands between the SDK and Vulkan: functions fail or are missing, devices say other things of themselves, and objects are
// counted.
#pragma once

#include "suite.h"

#include <vulkan/vulkan.h>

#include <map>
#include <set>

namespace agaa::conformance {

// One at a time. It outlives the contexts that are created with its getProcAddr.
class VulkanInterposer {
public:
    VulkanInterposer();
    ~VulkanInterposer();
    VulkanInterposer(const VulkanInterposer&) = delete;
    VulkanInterposer& operator=(const VulkanInterposer&) = delete;

    static AgaaVkFunction AGAA_CALL getProcAddr(void* instance, const char* name);

    std::set<std::string> missing; // functions that nobody has
    std::set<std::string> asked;   // functions that the SDK asked for, and that Vulkan has

    // The nth call from now on that can fail returns the error, and so do all later calls of the same function. 0: none.
    void failAt(uint32_t nth, VkResult error);
    const std::string& failed() const { return failed_; } // the function that failed; empty if none did

    // What the device says. Null: nothing is changed.
    std::function<void(VkPhysicalDeviceProperties&)> changeProperties;
    std::function<void(VkQueueFamilyProperties&)> changeQueueFamily; // of each family
    bool hasImageFormats = true; // false: the device supports images of no format

    // Objects that were created and not destroyed, by kind; kinds without such objects are not listed.
    std::map<std::string, int64_t> objects;

    // For the functions in place of Vulkan's.
    static VulkanInterposer* current;
    bool fails(const char* function, VkResult& error);
    void count(const char* kind, int64_t difference);

private:
    uint32_t remaining_ = 0;
    VkResult error_ = VK_SUCCESS;
    std::string failed_;
};

} // namespace agaa::conformance
