// An interposer between the SDK and Vulkan. It also hides functions, and changes the properties that devices report.
#pragma once

#include "interposer.h"

#include <vulkan/vulkan.h>

#include <set>
#include <vector>

namespace agaa::conformance {

// After a call failed, all later calls of the same function fail.
class VulkanInterposer : public Interposer {
public:
    VulkanInterposer();
    ~VulkanInterposer() override;

    void chainTo(ContextDescription& description) override { description.vk.getProcAddr = getProcAddr; }
    static AgaaVkFunction AGAA_CALL getProcAddr(void* instance, const char* name);

    std::set<std::string> missing;   // functions that getProcAddr does not find
    std::set<std::string> requested; // functions that the SDK requested and Vulkan has

    // The cache argument of each call of vkCreateComputePipelines and vkCreateGraphicsPipelines, in call order.
    std::vector<VkPipelineCache> pipelineCaches;

    // Live objects by handle: their kinds, and the names that the SDK gave them.
    std::map<uint64_t, std::string> kinds, names;

    // Change the properties of the device. Null changes nothing.
    std::function<void(VkPhysicalDeviceProperties&)> changeProperties;
    std::function<void(VkQueueFamilyProperties&)> changeQueueFamily; // called for each queue family
    std::function<void(VkFormat, VkFormatProperties&)> changeFormat;
    std::vector<const char*> moreExtensions;                        // that the SDK sees, even if the device lacks them
    std::vector<const char*> lessExtensions;                        // that the SDK does not see
    std::function<void(VkPhysicalDeviceFeatures2&)> changeFeatures; // with their chain
    // vkGetPhysicalDeviceSupportedFramebufferMixedSamplesCombinationsNV returns these, unless the list is empty.
    std::vector<VkFramebufferMixedSamplesCombinationNV> mixedSamples;
    // A device with VK_EXT_sample_locations. What the SDK asks of it is recorded, and Vulkan sees none of it.
    struct SampleLocations {
        bool isFaked = false;
        uint32_t subPixelBits = 4;
        float highest = 15.0f / 16;                         // coordinate
        VkSampleCountFlags counts = 0x1F;                   // of samples that can be placed
        std::vector<std::vector<VkSampleLocationEXT>> sets; // of vkCmdSetSampleLocationsEXT
        uint32_t images = 0;                                // whose depth may lie at set locations
        bool areVariable = true;                            // within a render pass
        // The locations of image barriers that leave the layout of a depth attachment; empty if a barrier has none.
        std::vector<std::vector<VkSampleLocationEXT>> transitions;
    } sampleLocations;
    bool hasImageFormats = true; // false: the device supports images of no format

    // Called by the functions that replace Vulkan's.
    static VulkanInterposer* current;
    bool fails(const char* function, VkResult& error);
    void addPipelineCache(VkPipelineCache cache);
    void addObject(const char* kind, uint64_t handle); // null is no object
    void removeObject(const char* kind, uint64_t handle);
    void nameObject(uint64_t handle, const char* name);
};

} // namespace agaa::conformance
