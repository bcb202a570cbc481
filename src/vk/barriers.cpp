#include "vk/barriers.h"

#include "vk/formats.h"

#include <algorithm>

namespace agaa::vk {

BarrierTracker::BarrierTracker(const Context& context, const Plan& plan,
                               const ViewResources& resources)
    : context_(context), plan_(plan), resources_(resources), states_(plan.resources.size()) {}

void BarrierTracker::beginFrame() {
    for (State& state : states_)
        state = {};
    // Of a frame that was given up while it was recorded.
    images_.clear();
    memory_.clear();
    source_ = destination_ = 0;
}

void BarrierTracker::use(ResourceId id, const VkAccess& access) {
    const Resource& resource = plan_.resources[id];
    if (resource.isHosts() || resource.kind == ResourceKind::UploadBuffer)
        return;
    State& state = states_[id];
    const bool isImage = resource.kind == ResourceKind::Image;
    const bool relayout = isImage && state.last.layout != access.layout;
    // A write that a stage already sees is seen by that stage's later reads of the same kind, too.
    const bool seen = std::any_of(state.seenBy.begin(), state.seenBy.end(), [&](const VkAccess& other) {
        return !(access.stages & ~other.stages) && !(access.reads & ~other.reads);
    });
    if (state.used && !state.written && !access.writes && !relayout && seen)
        return;
    // The first use follows whatever used this memory before, in this frame or the one before it.
    const VkPipelineStageFlags source =
        state.used ? state.last.stages | state.writeStages
                   : VkPipelineStageFlags(VK_PIPELINE_STAGE_ALL_COMMANDS_BIT);
    const VkAccessFlags sourceAccess =
        state.used ? state.writes : VkAccessFlags(VK_ACCESS_MEMORY_WRITE_BIT);
    source_ |= source;
    destination_ |= access.stages;
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
        images_.push_back(barrier);
    }
    // The image's barrier is of its own texels, not of another surface that had their memory.
    if (!isImage || (!state.used && plan_.aliases))
        memory_.push_back({VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, sourceAccess, access.reads | access.writes});
    const bool readAfterRead = state.used && !state.written && !access.writes && !relayout;
    const VkAccess before = readAfterRead ? state.last : VkAccess{};
    state.used = true;
    state.written = access.writes != 0;
    state.last = access;
    state.last.stages |= before.stages;
    if (access.writes || relayout)
        state.seenBy.clear();
    state.seenBy.push_back(access);
    if (access.writes || relayout) { // a layout transition writes, too
        state.writeStages = access.stages;
        state.writes = access.writes;
    }
}

VkAccess vkAccess(const Plan& plan, const Access& access) {
    const VkPipelineStageFlags shader = access.isDraw ? VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT
                                                      : VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
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
    case Use::Depth: // store operations count as writes
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

void BarrierTracker::usePass(const Pass& pass) {
    // Writes last: they are what later passes wait for.
    const std::vector<Access> accesses = accessesOf(pass);
    for (const bool writes : {false, true})
        for (const Access& access : accesses)
            if (access.writes() == writes)
                use(access.resource, vkAccess(plan_, access));
}

void BarrierTracker::useOutput(VkImage image, VkImageLayout from, VkImageLayout to, bool acquire) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    constexpr VkAccessFlags shader = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT;
    constexpr VkAccessFlags any = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.srcAccessMask = acquire ? VkAccessFlags(VK_ACCESS_MEMORY_WRITE_BIT)
                                    : VkAccessFlags(VK_ACCESS_SHADER_WRITE_BIT);
    barrier.dstAccessMask = acquire ? shader : any;
    source_ |= acquire ? VK_PIPELINE_STAGE_ALL_COMMANDS_BIT : VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    destination_ |=
        acquire ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT : VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
    images_.push_back(barrier);
}

void BarrierTracker::record(VkCommandBuffer commands) {
    if (images_.empty() && memory_.empty())
        return;
    context_.vk.CmdPipelineBarrier(commands, source_, destination_, 0, uint32_t(memory_.size()),
                                   memory_.data(), 0, nullptr, uint32_t(images_.size()),
                                   images_.data());
    images_.clear();
    memory_.clear();
    source_ = destination_ = 0;
}

} // namespace agaa::vk
