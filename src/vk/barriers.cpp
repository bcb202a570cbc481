#include "vk/barriers.h"

#include "vk/formats.h"

#include <algorithm>
#include <utility>

namespace agaa::vk {

VkAccess vkAccess(const Plan& plan, const Access& access) {
    const VkPipelineStageFlags shader =
        access.isDraw ? VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT : VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    switch (access.use) {
    case Use::Uniform:
        return {shader, VK_ACCESS_UNIFORM_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
    case Use::StorageRead:
        return {shader, VK_ACCESS_SHADER_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
    case Use::StorageWrite:
        return {shader, VK_ACCESS_SHADER_READ_BIT, VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_UNDEFINED};
    case Use::Fetch:
        return {shader, VK_ACCESS_SHADER_READ_BIT, 0,
                isDepth(plan.resources[access.resource].format) ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL
                                                                : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    case Use::ImageWrite:
        return {shader, VK_ACCESS_SHADER_READ_BIT, VK_ACCESS_SHADER_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL};
    case Use::Color:
        return {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_COLOR_ATTACHMENT_READ_BIT,
                VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    case Use::FetchedColor:
        return {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT,
                VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_INPUT_ATTACHMENT_READ_BIT,
                VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL};
    case Use::Depth: // store operations are writes
        return {VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT,
                VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT, VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    case Use::CopyFrom:
        return {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
    case Use::CopyTo:
        return {VK_PIPELINE_STAGE_TRANSFER_BIT, 0, VK_ACCESS_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_UNDEFINED};
    case Use::Condition:
        return {VK_PIPELINE_STAGE_CONDITIONAL_RENDERING_BIT_EXT, VK_ACCESS_CONDITIONAL_RENDERING_READ_BIT_EXT, 0,
                VK_IMAGE_LAYOUT_UNDEFINED};
    case Use::Indirect:
        break;
    }
    return {VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT, VK_ACCESS_INDIRECT_COMMAND_READ_BIT, 0, VK_IMAGE_LAYOUT_UNDEFINED};
}

namespace {

// Tracks the accesses to resources through a frame.
class Tracker {
public:
    Tracker(const Plan& plan, const ViewResources& resources)
        : plan_(plan), resources_(resources), states_(plan.resources.size()) {}

    // Adds the barriers that an access needs.
    void use(ResourceId id, const VkAccess& access);
    void usePass(const Pass& pass);
    void useOutputs(const Step& step);
    StepBarriers take() { return std::exchange(next_, {}); }

private:
    struct State {
        bool used = false;
        VkAccess last; // the last write, or all reads since it
        bool written = false;
        VkPipelineStageFlags writeStages = 0; // of the last write: reads in other stages must wait for it
        VkAccessFlags writes = 0;             // of the last write
        std::vector<VkAccess> seenBy;         // reads that already wait for the last write
    };
    const Plan& plan_;
    const ViewResources& resources_;
    std::vector<State> states_;
    StepBarriers next_;
};

void Tracker::use(ResourceId id, const VkAccess& access) {
    const Resource& resource = plan_.resources[id];
    if (resource.isImported() || resource.kind == ResourceKind::UploadBuffer)
        return;
    State& state = states_[id];
    const bool isImage = resource.kind == ResourceKind::Image;
    const bool relayout = isImage && state.last.layout != access.layout;
    // A write that is visible to a stage is visible to all later reads of the same kind in that stage.
    const bool seen = std::any_of(state.seenBy.begin(), state.seenBy.end(), [&](const VkAccess& other) {
        return !(access.stages & ~other.stages) && !(access.reads & ~other.reads);
    });
    if (state.used && !state.written && !access.writes && !relayout && seen)
        return;
    // The first use waits for every earlier use of this memory, in this frame or the frame before.
    const VkPipelineStageFlags source =
        state.used ? state.last.stages | state.writeStages : VkPipelineStageFlags(VK_PIPELINE_STAGE_ALL_COMMANDS_BIT);
    const VkAccessFlags sourceAccess = state.used ? state.writes : VkAccessFlags(VK_ACCESS_MEMORY_WRITE_BIT);
    next_.source |= source;
    next_.destination |= access.stages;
    if (isImage) {
        VkImageMemoryBarrier barrier{};
        barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
        barrier.srcAccessMask = sourceAccess;
        barrier.dstAccessMask = access.reads | access.writes;
        barrier.oldLayout = state.last.layout;
        barrier.newLayout = access.layout;
        barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        barrier.image = resources_[id].image;
        barrier.subresourceRange = {aspects(resource.format), 0, 1, 0, resource.layers};
        if (hasSetLocations(plan_, resource)) // a transition may compute the depth at each sample
            barrier.pNext = resources_.sampleLocations();
        next_.images.push_back(barrier);
    }
    // An image barrier covers the image's own texels, not the aliased surface that used their memory before.
    if (!isImage || (!state.used && plan_.aliases))
        next_.memory.push_back({VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, sourceAccess, access.reads | access.writes});
    const bool readAfterRead = state.used && !state.written && !access.writes && !relayout;
    const VkAccess before = readAfterRead ? state.last : VkAccess{};
    state.used = true;
    state.written = access.writes != 0;
    state.last = access;
    state.last.stages |= before.stages;
    if (access.writes || relayout)
        state.seenBy.clear();
    state.seenBy.push_back(access);
    if (access.writes || relayout) { // a layout transition is a write
        state.writeStages = access.stages;
        state.writes = access.writes;
    }
}

void Tracker::usePass(const Pass& pass) {
    // Writes come last because later passes wait for them.
    const std::vector<Access> accesses = accessesOf(pass);
    for (const bool writes : {false, true})
        for (const Access& access : accesses)
            if (access.writes() == writes)
                use(access.resource, vkAccess(plan_, access));
}

VkImageMemoryBarrier outputBarrier() {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.oldLayout = barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    return barrier;
}

struct OutputAccess {
    VkAccessFlags reads, writes;
};

// Returns the accesses of the host that a layout of the output permits. Layouts without writes have none to wait for:
// the host's transition to the layout made earlier writes available.
OutputAccess accessIn(VkImageLayout layout) {
    switch (layout) {
    case VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL:
        return {VK_ACCESS_TRANSFER_READ_BIT, 0};
    case VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL:
        return {0, VK_ACCESS_TRANSFER_WRITE_BIT};
    case VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL:
        return {VK_ACCESS_COLOR_ATTACHMENT_READ_BIT, VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT};
    case VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL:
        return {VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_INPUT_ATTACHMENT_READ_BIT, 0};
    case VK_IMAGE_LAYOUT_PRESENT_SRC_KHR: // the presentation engine waits for a semaphore
        return {0, 0};
    default:
        return {VK_ACCESS_MEMORY_READ_BIT, VK_ACCESS_MEMORY_WRITE_BIT};
    }
}

// Each use of an output waits for the host's use or for that of an earlier step.
void Tracker::useOutputs(const Step& step) {
    for (const Binding& binding : plan_.passes[step.pass].bindings) {
        const Resource& resource = plan_.resources[binding.resource];
        const auto isSame = [&](const StepBarriers::Output& used) { return used.hostSlot == resource.hostSlot; };
        if (resource.kind != ResourceKind::Output || std::ranges::any_of(next_.outputs, isSame))
            continue;
        VkImageMemoryBarrier barrier = outputBarrier();
        barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
        barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
        next_.source |= VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
        next_.destination |= VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
        next_.images.push_back(barrier);
        next_.outputs.push_back({resource.hostSlot, step.pass == resource.firstPass && step.isFirst,
                                 step.pass == resource.lastPass && step.isLast});
    }
}

} // namespace

std::vector<StepBarriers> stepBarriers(const Plan& plan, const std::vector<Step>& steps, const ViewResources& resources,
                                       bool readsPredicates) {
    Tracker tracker(plan, resources);
    std::vector<StepBarriers> list;
    list.reserve(steps.size());
    for (const Step& step : steps) {
        tracker.usePass(plan.passes[step.pass]);
        // This follows the pass's own accesses, so that later steps also wait for the read of the predicate.
        if (readsPredicates && step.hasPredicate())
            tracker.use(step.predicateBuffer, vkAccess(plan, {step.predicateBuffer, Use::Condition, false}));
        tracker.useOutputs(step);
        list.push_back(tracker.take());
    }
    return list;
}

void recordBarriers(const DeviceTable& vk, VkCommandBuffer commands, StepBarriers& barriers,
                    const OutputImages& outputs) {
    if (barriers.images.empty() && barriers.memory.empty())
        return;
    size_t at = barriers.images.size() - barriers.outputs.size();
    for (const StepBarriers::Output& used : barriers.outputs) {
        VkImageMemoryBarrier& barrier = barriers.images[at++];
        const OutputImage& output = outputs[used.hostSlot];
        barrier.image = output.image;
        if (used.begins) {
            barrier.oldLayout = output.layoutIn;
            barrier.srcAccessMask = accessIn(output.layoutIn).writes;
        }
    }
    vk.CmdPipelineBarrier(commands, barriers.source, barriers.destination, 0, uint32_t(barriers.memory.size()),
                          barriers.memory.data(), 0, nullptr, uint32_t(barriers.images.size()), barriers.images.data());
}

void releaseOutputs(const DeviceTable& vk, VkCommandBuffer commands, const StepBarriers& barriers,
                    const OutputImages& outputs) {
    std::array<VkImageMemoryBarrier, std::tuple_size_v<OutputImages>> released;
    uint32_t count = 0;
    for (const StepBarriers::Output& used : barriers.outputs) {
        if (!used.ends)
            continue;
        VkImageMemoryBarrier& barrier = released[count++] = outputBarrier();
        barrier.image = outputs[used.hostSlot].image;
        barrier.newLayout = outputs[used.hostSlot].layoutOut;
        barrier.srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT;
        const OutputAccess later = accessIn(barrier.newLayout);
        barrier.dstAccessMask = later.reads | later.writes;
    }
    if (count)
        vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0,
                              nullptr, 0, nullptr, count, released.data());
}

} // namespace agaa::vk
