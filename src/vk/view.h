// One camera's frame on Vulkan: a plan with everything it needs to be recorded again and again.
#pragma once

#include "core/plan.h"
#include "vk/barriers.h"
#include "vk/context.h"
#include "vk/host_passes.h"
#include "vk/resources.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace agaa::vk {

// Objects of a pass that live as long as the view.
struct PassObjects {
    VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
    std::vector<VkDescriptorSet> sets; // one per frame in flight
    VkPipelineLayout pipelineLayout = VK_NULL_HANDLE;
    VkPipeline pipeline = VK_NULL_HANDLE; // compute
    HostPassObjects host;                 // host draws
};

// What belongs to one frame in flight.
struct FrameSlot {
    uint64_t frame = 0; // that used it last
    VkCommandPool pool = VK_NULL_HANDLE;
    std::vector<VkCommandBuffer> secondaries; // one per host draw, in order
    bool complete = false;                    // every segment was recorded
};

} // namespace agaa::vk

struct AgaaView_T {
    AgaaView_T(AgaaContext_T& context, const AgaaViewDesc& desc);
    ~AgaaView_T();
    AgaaView_T(const AgaaView_T&) = delete;
    AgaaView_T& operator=(const AgaaView_T&) = delete;

    AgaaResult record(const AgaaFrame& frame, const AgaaVkFrame& vkFrame);
    AgaaResult statistics(uint64_t completedFrame, AgaaFrameStatistics& out) const;

    AgaaContext_T& context;
    agaa::Plan plan;
    std::optional<agaa::vk::ViewResources> resources;
    std::vector<agaa::vk::PassObjects> passes;
    std::vector<agaa::vk::FrameSlot> slots;
    std::optional<agaa::vk::BarrierTracker> barriers;
    VkDescriptorPool descriptorPool = VK_NULL_HANDLE;
    VkQueryPool queries = VK_NULL_HANDLE; // two timestamps per pass and slot
    uint64_t currentFrame = 0;
    uint32_t currentSlot = 0;
    uint64_t recordedSegments = 0; // of the current frame
    std::array<float, 32> currentCamera{}; // view and projection of the current frame

private:
    void createPassObjects();
    void createPipelines();
    void createSlots();
    void destroy();
    void checkOrder(const AgaaFrame& frame, uint32_t slot) const;
    void checkTarget(const AgaaFrame& frame, const AgaaVkFrame& vkFrame) const;
    void writeFrameData(const AgaaFrame& frame, uint32_t slot);
    void recordPasses(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, uint32_t slot,
                      bool begins);
    void writeDescriptors(const AgaaVkFrame& vkFrame, uint32_t slot, uint64_t segments);
    AgaaResult callHost(const AgaaFrame& frame, size_t pass, uint32_t slot,
                        VkCommandBuffer commands);
    AgaaResult recordSecondaries(const AgaaFrame& frame, uint32_t slot);
    void recordPass(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, size_t pass,
                          uint32_t slot, VkCommandBuffer commands);
    void recordCompute(const AgaaVkFrame& vkFrame, size_t pass, uint32_t slot,
                       VkCommandBuffer commands);
    void recordTransfer(const agaa::Pass& pass, uint32_t slot, VkCommandBuffer commands);
    size_t secondaryIndex(size_t pass) const;
    bool usesHostSet(const agaa::Pass& pass) const; // set 1 is the host's
    bool timed() const;
};
