// Barriers between passes, derived once per view from the accesses of the passes. Frames differ in the barriers of the
// host's output only.
#pragma once

#include "core/plan/access.h"
#include "vk/output_images.h"
#include "vk/resources.h"

#include <vector>

namespace agaa::vk {

// An access in terms of Vulkan.
struct VkAccess {
    VkPipelineStageFlags stages = 0;
    VkAccessFlags reads = 0;
    VkAccessFlags writes = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED; // images only
};

VkAccess vkAccess(const Plan& plan, const Access& access);

// The barriers before a step of a frame.
struct StepBarriers {
    VkPipelineStageFlags source = 0;
    VkPipelineStageFlags destination = 0;
    std::vector<VkMemoryBarrier> memory;
    std::vector<VkImageMemoryBarrier> images;
    // The last image barriers are those of images of the host, in this order.
    struct Output {
        uint32_t hostSlot = 0;
        bool begins = false; // from the host's layout
        bool ends = false;   // no later step uses the image
    };
    std::vector<Output> outputs;
};

// Returns the barriers of each step. Multiple calls may record the steps of one frame. The first use of a resource in a
// frame waits for all commands recorded before, and the contents of an image are lost. readsPredicates: the device
// reads Step::predicateBuffer.
std::vector<StepBarriers> stepBarriers(const Plan& plan, const std::vector<Step>& steps, const ViewResources& resources,
                                       bool readsPredicates);

// Records the barriers of a step as one command, with the outputs of this frame.
void recordBarriers(const DeviceTable& vk, VkCommandBuffer commands, StepBarriers& barriers,
                    const OutputImages& outputs);
// Records the transitions of the outputs that the step used last, to the layouts in which the host wants them.
void releaseOutputs(const DeviceTable& vk, VkCommandBuffer commands, const StepBarriers& barriers,
                    const OutputImages& outputs);

} // namespace agaa::vk
