#include "vk/barriers.h"

#include "vk/formats.h"

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

void BarrierTracker::use(ResourceId id, const Access& access) {
    const Resource& resource = plan_.resources[id];
    if (resource.isHosts() || resource.kind == ResourceKind::UploadBuffer)
        return;
    State& state = states_[id];
    const bool isImage = resource.kind == ResourceKind::Image;
    const bool relayout = isImage && state.last.layout != access.layout;
    // A write that some stage already sees is seen by that stage's later reads too.
    const bool seen = !(access.stages & ~state.last.stages);
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
        barrier.subresourceRange = {aspects(resource.format), 0, 1, 0, 1};
        images_.push_back(barrier);
    }
    // The image's barrier is of its own texels, not of another surface that had their memory.
    if (!isImage || (!state.used && plan_.aliases))
        memory_.push_back({VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, sourceAccess, access.reads | access.writes});
    const bool readAfterRead = state.used && !state.written && !access.writes && !relayout;
    const VkPipelineStageFlags readers = readAfterRead ? state.last.stages : 0;
    state.used = true;
    state.written = access.writes != 0;
    state.last = access;
    state.last.stages |= readers;
    if (access.writes || relayout) { // a layout transition writes, too
        state.writeStages = access.stages;
        state.writes = access.writes;
    }
}

std::vector<ResourceAccess> accessesOf(const Plan& plan, const Pass& pass) {
    std::vector<ResourceAccess> list;
    const bool host = pass.kind == PassKind::HostDraw;
    const VkPipelineStageFlags shader = host ? VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT
                                             : VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    for (const Binding& binding : pass.bindings) {
        Access access{shader, VK_ACCESS_SHADER_READ_BIT, 0, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        if (binding.writes)
            access.writes = VK_ACCESS_SHADER_WRITE_BIT;
        if (binding.type == BindingType::StorageImage)
            access.layout = VK_IMAGE_LAYOUT_GENERAL;
        else if (isDepth(plan.resources[binding.resource].format))
            access.layout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;
        list.push_back({binding.resource, access});
    }
    for (ResourceId target : pass.colorTargets)
        list.push_back({target,
                        {VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                         VK_ACCESS_COLOR_ATTACHMENT_READ_BIT, VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                         VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL}});
    // The stencil is written where depth is only compared, and store operations count as writes.
    if (pass.depthTarget != noResource)
        list.push_back({pass.depthTarget,
                        {VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                             VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT,
                         VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
                         VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                         VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}});
    if (pass.source != noResource)
        list.push_back({pass.source,
                        {VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_READ_BIT, 0,
                         VK_IMAGE_LAYOUT_UNDEFINED}});
    if (pass.destination != noResource)
        list.push_back({pass.destination,
                        {VK_PIPELINE_STAGE_TRANSFER_BIT, 0, VK_ACCESS_TRANSFER_WRITE_BIT,
                         VK_IMAGE_LAYOUT_UNDEFINED}});
    return list;
}

void BarrierTracker::usePass(const Pass& pass) {
    for (const ResourceAccess& each : accessesOf(plan_, pass))
        use(each.resource, each.access);
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
