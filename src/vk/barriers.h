// Barriers between passes, derived from what each pass does with each resource. Every frame has the same but for the host's
// output: they are derived once.
#pragma once

#include "core/plan/access.h"
#include "vk/resources.h"

#include <vector>

namespace agaa::vk {

// How Vulkan sees an access.
struct VkAccess {
    VkPipelineStageFlags stages = 0;
    VkAccessFlags reads = 0;
    VkAccessFlags writes = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; // images
};

VkAccess vkAccess(const Plan& plan, const Access& access);

// Before a step of a frame.
struct StepBarriers {
    VkPipelineStageFlags source = 0;
    VkPipelineStageFlags destination = 0;
    std::vector<VkMemoryBarrier> memory;
    std::vector<VkImageMemoryBarrier> images;
    bool usesOutput = false;   // the host's, of the last image
    bool beginsOutput = false; // in the layout that the host left it in
    bool endsOutput = false;   // no later step uses it
};

// In the order of the steps, which may be recorded in several calls. The first use of a resource in a frame waits for all that
// was recorded before, and an image's contents are lost. readsConditions: the device reads Step::predicateBuffer.
std::vector<StepBarriers> stepBarriers(const Plan& plan, const std::vector<Step>& steps, const ViewResources& resources,
                                       bool readsConditions);

// All of a step as one command, with the output of this frame.
void recordBarriers(const DeviceTable& vk, VkCommandBuffer commands, StepBarriers& barriers, const AgaaVkFrame& frame);
// Leaves the output to the host.
void releaseOutput(const DeviceTable& vk, VkCommandBuffer commands, const AgaaVkFrame& frame);

} // namespace agaa::vk
