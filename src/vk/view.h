// A view on Vulkan: a plan with the objects that record it.
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

// Objects of a pass, which live as long as the view.
struct PassObjects {
    VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
    std::vector<VkDescriptorSet> sets; // one per frame in flight
    VkPipelineLayout pipelineLayout = VK_NULL_HANDLE;
    HostRenderTarget target; // host passes only
};

// Objects of one frame in flight.
struct FrameSlot {
    VkCommandPool pool = VK_NULL_HANDLE;
    std::vector<VkCommandBuffer> secondaries; // by pass; used by draws of the host
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
    std::vector<StepBarriers> barriers; // by step
    VkDescriptorPool descriptorPool = VK_NULL_HANDLE;
    VkQueryPool queries = VK_NULL_HANDLE; // two timestamps per step and slot

private:
    void createPassObjects();
    void createPipelineLayouts();
    Compiled compile(const Pass& pass, size_t index) override;
    void createSlots();
    void destroy();
    void checkTarget(const AgaaFrame& frame, const AgaaVkFrame& vkFrame); // sets outputs_
    std::byte* beginUpload(ResourceId buffer, uint32_t slot) override;
    void endUpload(ResourceId buffer, uint32_t slot, uint64_t bytes) override;
    const std::byte* mappedBreadcrumbs() const override;
    void readBuffer(ResourceId buffer, uint32_t slot, uint64_t offset, std::span<std::byte> data) const override;
    void recordPasses(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, const Variant& variant, uint32_t slot,
                      bool begins);
    void writeStaticDescriptors();
    void writeStatic(VkDescriptorSet set, const Binding& binding, uint32_t slot);
    void writeImportedDescriptors(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, uint32_t slot);
    bool isConditional(const Step& step) const; // the device reads Step::predicateBuffer
    void beginCondition(const Step& step, uint32_t slot, VkCommandBuffer commands) const;
    void endCondition(const Step& step, VkCommandBuffer commands) const;
    AgaaResult callHost(const AgaaFrame& frame, const Step& step, uint32_t slot, VkCommandBuffer commands);
    void recordSecondaries(const AgaaFrame& frame, uint32_t slot);
    // Writes a member of BreadcrumbBuffer.
    void recordBreadcrumb(uint64_t offset, const Breadcrumb& crumb, VkCommandBuffer commands) const;
    // number: index of the step.
    void recordStep(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, const Variant& variant, size_t number,
                    uint32_t slot, VkCommandBuffer commands);
    void recordCompute(const AgaaVkFrame& vkFrame, const Variant& variant, size_t pass, FrameExtent extent,
                       uint32_t slot, VkCommandBuffer commands);
    void recordFill(const FillPart& fill, uint64_t frameIndex, uint32_t slot, VkCommandBuffer commands);
    void recordTransfer(const Pass& pass, uint64_t frameIndex, uint32_t slot, VkCommandBuffer commands);
    bool needsClear(const AgaaFrame& frame);
    void clearPersistent(VkCommandBuffer commands);
    void discardClear(const AgaaFrame& frame);
    bool usesHostSet(const Pass& pass) const; // the host provides set 1
    bool timed() const;

    OutputImages outputs_;   // of the frame that is recorded
    uint64_t clearedIn_ = 0; // index of the frame that cleared persistent buffers; 0: none
    bool isCleared_ = false; // the device executed that frame
};

} // namespace agaa::vk
