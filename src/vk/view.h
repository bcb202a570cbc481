// One camera's frame on Vulkan: a plan with everything it needs to be recorded again and again.
#pragma once

#include "core/plan/plan.h"
#include "vk/barriers.h"
#include "vk/context.h"
#include "vk/host_passes.h"
#include "vk/resources.h"

#include <optional>
#include <vector>

namespace agaa::vk {

VkDescriptorType descriptorType(BindingType type);

// Objects of a pass that live as long as the view.
struct PassObjects {
    VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
    std::vector<VkDescriptorSet> sets; // one per frame in flight
    VkPipelineLayout pipelineLayout = VK_NULL_HANDLE;
    HostRenderTarget target;           // host draws
};

// What belongs to one frame in flight.
struct FrameSlot {
    VkCommandPool pool = VK_NULL_HANDLE;
    std::vector<VkCommandBuffer> secondaries; // one per step that is a host draw, in order
};

class View : public ViewState {
public:
    View(Context& owner, const ViewSettings& settings);
    View(Context& owner, Plan plan);
    ~View() override;

    ViewState* recreate(const ViewSettings& settings) const override;
    AgaaResult record(AgaaFrame frame, const AgaaVkFrame& vkFrame);

    MemoryUse memoryUse() const override;
    const StructRow& drawPassRow() const override;
    const StructRow& surfaceRow() const override;
    void describePass(size_t index, void* native) const override;
    void describeSurface(ResourceId id, void* native) const override;
    std::vector<double> readPassTimes(uint32_t slot) const override;
    AgaaTimeSource timeSource() const override { return AGAA_TIME_DEVICE; }

    Context& context;
    std::optional<ViewResources> resources;
    std::vector<PassObjects> passes;
    std::vector<FrameSlot> slots;
    std::vector<StepBarriers> barriers; // of the steps
    VkDescriptorPool descriptorPool = VK_NULL_HANDLE;
    VkQueryPool queries = VK_NULL_HANDLE; // two timestamps per pass and slot

private:
    void createPassObjects();
    void createPipelineLayouts();
    Compiled compile(const Pass& pass, size_t index) override;
    void createSlots();
    void destroy();
    void checkTarget(const AgaaFrame& frame, const AgaaVkFrame& vkFrame) const;
    void writeBuffer(ResourceId buffer, uint32_t slot, std::span<const std::byte> data) override;
    void readBuffer(ResourceId buffer, uint32_t slot, uint64_t offset, std::span<std::byte> data) const override;
    void recordPasses(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, const Variant& variant, uint32_t slot,
                      bool begins);
    void writeStaticDescriptors();
    void writeStatic(VkDescriptorSet set, const Binding& binding, uint32_t slot);
    void writeHostsDescriptors(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, uint32_t slot);
    bool isConditional(const Step& step) const; // the device reads Step::predicateBuffer
    void beginCondition(const Step& step, uint32_t slot, VkCommandBuffer commands) const;
    void endCondition(const Step& step, VkCommandBuffer commands) const;
    AgaaResult callHost(const AgaaFrame& frame, const Step& step, uint32_t slot, VkCommandBuffer commands);
    void recordSecondaries(const AgaaFrame& frame, uint32_t slot);
    // secondary: of the host draws among the steps.
    void recordStep(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, const Variant& variant, size_t number,
                    size_t secondary, uint32_t slot, VkCommandBuffer commands);
    void recordCompute(const AgaaVkFrame& vkFrame, const Variant& variant, size_t pass, uint32_t slot,
                       VkCommandBuffer commands);
    void recordTransfer(const Pass& pass, uint32_t slot, VkCommandBuffer commands);
    void clearPersistent(VkCommandBuffer commands);
    void forgetClear(const AgaaFrame& frame);
    bool usesHostSet(const Pass& pass) const; // set 1 is the host's
    bool timed() const;

    uint64_t clearedIn_ = 0; // the frame that cleared what outlives frames; 0: none yet
};

} // namespace agaa::vk
