// Barriers between passes, derived from what each pass does with each resource.
#pragma once

#include "core/access.h"
#include "vk/context.h"
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

class BarrierTracker {
public:
    BarrierTracker(const Context& context, const Plan& plan, const ViewResources& resources);

    // Forgets the frame before: every resource's contents are undefined and its memory may have held
    // another resource.
    void beginFrame();
    // Collects what a pass needs; record() emits it as one barrier.
    void use(ResourceId id, const VkAccess& access);
    void usePass(const Pass& pass);
    // The host's output around the shading segment.
    void useOutput(VkImage image, VkImageLayout from, VkImageLayout to, bool acquire);
    void record(VkCommandBuffer commands);

private:
    struct State {
        bool used = false;
        VkAccess last; // the last write, or all reads since
        bool written = false;
        VkPipelineStageFlags writeStages = 0; // of the last write, which later reads elsewhere
        VkAccessFlags writes = 0;             // must still see
        std::vector<VkAccess> seenBy;         // reads that wait for the last write
    };
    const Context& context_;
    const Plan& plan_;
    const ViewResources& resources_;
    std::vector<State> states_;
    std::vector<VkImageMemoryBarrier> images_;
    std::vector<VkMemoryBarrier> memory_;
    VkPipelineStageFlags source_ = 0;
    VkPipelineStageFlags destination_ = 0;
};

} // namespace agaa::vk
