// Records a frame: checks it, calls the draw callbacks, then records the passes and the barriers between them.
#include "core/base/error.h"
#include "core/frame/frame_checks.h"
#include "vk/view.h"

#include <cstring>
#include <new>

namespace agaa::vk {

void View::checkTarget(const AgaaFrame& frame, const AgaaVkFrame& vkFrame) {
    require(vkFrame.commandBuffer, AGAA_ERROR_INVALID_ARGUMENT, "AgaaVkFrame::commandBuffer is null.");
    for (const Pass& pass : plan.passes)
        require(!(frame.segments & pass.segment) || !usesHostSet(pass) || vkFrame.functionSet,
                AGAA_ERROR_INVALID_ARGUMENT, "AgaaVkFrame::functionSet is null.");
    if (!(frame.segments & AGAA_SEGMENT_SHADING))
        return;
    outputs_ = outputImages(plan, frame, vkFrame);
    checkComposite(frame, plan);
    require(vkFrame.outputLayoutIn != VK_IMAGE_LAYOUT_UNDEFINED || frame.background[3] != 0.0f, AGAA_ERROR_OUT_OF_RANGE,
            "the frame composites over an output whose contents outputLayoutIn throws away.");
    bool first = true; // the first view also fills the slots of maps that the frame lacks
    for (const Resource& resource : plan.resources) {
        if (resource.kind != ResourceKind::ShadowMap)
            continue;
        if ((first || resource.hostSlot < frame.shadowCount) && !vkFrame.shadowViews[resource.hostSlot])
            fail(AGAA_ERROR_INVALID_ARGUMENT, format("AgaaVkFrame::shadowViews[%u] is null.", resource.hostSlot));
        first = false;
    }
}

bool View::isConditional(const Step& step) const { return context.conditionalRendering && step.hasPredicate(); }

// The device skips draws and dispatches between beginCondition() and endCondition() if the predicate is not 0.
// Barriers, timestamps, and the commands that begin and end rendering are outside or are not affected.
void View::beginCondition(const Step& step, uint32_t slot, VkCommandBuffer commands) const {
    if (!isConditional(step))
        return;
    VkConditionalRenderingBeginInfoEXT info{};
    info.sType = VK_STRUCTURE_TYPE_CONDITIONAL_RENDERING_BEGIN_INFO_EXT;
    info.buffer = resources->buffer(step.predicateBuffer, slot);
    info.offset = step.predicateOffset;
    info.flags = VK_CONDITIONAL_RENDERING_INVERTED_BIT_EXT;
    context.vk.CmdBeginConditionalRenderingEXT(commands, &info);
}

void View::endCondition(const Step& step, VkCommandBuffer commands) const {
    if (isConditional(step))
        context.vk.CmdEndConditionalRenderingEXT(commands);
}

// The condition begins and ends in the host's command buffer, inside the render pass, so that the device does not need
// inheritedConditionalRendering.
AgaaResult View::callHost(const AgaaFrame& frame, const Step& step, uint32_t slot, VkCommandBuffer commands) {
    AgaaDrawTarget target = drawTarget(plan, step, hostPasses[step.pass], extentOf(frame, plan));
    target.commandBuffer = commands;
    target.descriptorSet = (uint64_t)passes[step.pass].sets[slot];
    if (target.state.sampleLocations)
        context.vk.CmdSetSampleLocationsEXT(commands, resources->sampleLocations());
    beginCondition(step, slot, commands);
    const AgaaResult result = callDraw(plan, plan.passes[step.pass], frame, target);
    endCondition(step, commands);
    return result;
}

// Draw callbacks record into secondary command buffers first: a callback that fails leaves the host's command buffer as
// it was. The draws of a repetition execute one of them, so that the host records its scene once.
void View::recordSecondaries(const AgaaFrame& frame, uint32_t slot) {
    for (const Step& step : steps) {
        const Pass& pass = plan.passes[step.pass];
        if (pass.kind() != PassKind::HostDraw || !step.isFirst || !(pass.segment & frame.segments))
            continue;
        const VkCommandBuffer commands = slots[slot].secondaries[step.pass];
        beginSecondary(context, pass, hostPasses[step.pass], passes[step.pass].target, !step.isLast, commands);
        const AgaaResult result = callHost(frame, step, slot, commands);
        check(context.vk.EndCommandBuffer(commands), "vkEndCommandBuffer");
        if (result != AGAA_OK)
            failDraw(AGAA_ERROR_CALLBACK, result, pass, "nothing was recorded");
    }
}

void View::recordCompute(const AgaaVkFrame& vkFrame, const Variant& variant, size_t pass, FrameExtent extent,
                         uint32_t slot, VkCommandBuffer commands) {
    const PassObjects& objects = passes[pass];
    const VkDescriptorSet sets[] = {objects.sets[slot], (VkDescriptorSet)vkFrame.functionSet};
    context.vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, (VkPipeline)variant.programs[pass]);
    context.vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, objects.pipelineLayout, 0,
                                     usesHostSet(plan.passes[pass]) ? 2 : 1, sets, 0, nullptr);
    const Dispatch& dispatch = plan.passes[pass].compute().dispatch;
    if (dispatch.kind == DispatchKind::Indirect) {
        context.vk.CmdDispatchIndirect(commands, resources->buffer(dispatch.arguments, slot), dispatch.argumentsOffset);
        return;
    }
    const auto [x, y] = plan.groups(dispatch, extent);
    context.vk.CmdDispatch(commands, x, y, 1);
}

// Persistent buffers must be cleared if no frame has cleared them, or if the host discarded the frame that did. While
// that frame is unfinished, the device is expected to execute it.
bool View::needsClear(const AgaaFrame& frame) {
    if (sequence.changesSize(frame))
        return true;
    if (isCleared_)
        return false;
    const FrameSequence::Slot* clearing = clearedIn_ ? sequence.find(clearedIn_) : nullptr;
    if (!clearing)
        return clearedIn_ == 0;
    if (clearing->frame > frame.completedFrame)
        return false;
    isCleared_ = wasExecuted(*clearing);
    return !isCleared_;
}

// Clears persistent buffers to 0. The barrier waits for earlier uses of their memory. No barrier follows: the first use
// in each frame waits for all commands recorded before.
void View::clearPersistent(VkCommandBuffer commands) {
    const VkMemoryBarrier before{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_MEMORY_WRITE_BIT,
                                 VK_ACCESS_TRANSFER_WRITE_BIT};
    for (ResourceId id = 0; id < plan.resources.size(); ++id)
        if (plan.resources[id].isPersistent) {
            context.vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                                          0, 1, &before, 0, nullptr, 0, nullptr);
            context.vk.CmdFillBuffer(commands, resources->buffer(id, 0), 0, VK_WHOLE_SIZE, 0);
        }
}

// If the frame cleared the persistent buffers, its commands are discarded and the next frame clears again.
void View::discardClear(const AgaaFrame& frame) {
    if (clearedIn_ == frame.frameIndex)
        clearedIn_ = 0;
}

// Fills the words before the stamp, the stamp and the words after it. The ranges are disjoint and need no barrier.
void View::recordFill(const FillPart& fill, uint64_t frameIndex, uint32_t slot, VkCommandBuffer commands) {
    const VkBuffer buffer = resources->buffer(fill.destination, slot);
    if (fill.stampOffset == noStamp) {
        context.vk.CmdFillBuffer(commands, buffer, 0, fill.bytes ? fill.bytes : VK_WHOLE_SIZE, fill.value);
        return;
    }
    const uint64_t end = fill.stampOffset + sizeof(uint32_t), bytes = plan.resources[fill.destination].bytes;
    if (fill.stampOffset > 0)
        context.vk.CmdFillBuffer(commands, buffer, 0, fill.stampOffset, fill.value);
    context.vk.CmdFillBuffer(commands, buffer, fill.stampOffset, sizeof(uint32_t), stampOf(frameIndex));
    if (end < bytes)
        context.vk.CmdFillBuffer(commands, buffer, end, bytes - end, fill.value);
}

void View::recordTransfer(const Pass& pass, uint64_t frameIndex, uint32_t slot, VkCommandBuffer commands) {
    ResourceId destination = noResource;
    if (pass.kind() == PassKind::Fill) {
        destination = pass.fill().destination;
        recordFill(pass.fill(), frameIndex, slot, commands);
    } else {
        destination = pass.copy().destination;
        const VkBufferCopy region{0, 0, plan.bytesOf(pass.copy())};
        context.vk.CmdCopyBuffer(commands, resources->buffer(pass.copy().source, slot),
                                 resources->buffer(destination, slot), 1, &region);
    }
    if (plan.resources[destination].kind != ResourceKind::ReadbackBuffer)
        return;
    const VkMemoryBarrier toHost{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT,
                                 VK_ACCESS_HOST_READ_BIT};
    context.vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &toHost,
                                  0, nullptr, 0, nullptr);
}

// The host reads the memory also if the device never gets farther, so the write becomes visible at once.
void View::recordBreadcrumb(uint64_t offset, const Breadcrumb& crumb, VkCommandBuffer commands) const {
    context.vk.CmdUpdateBuffer(commands, resources->buffer(plan.breadcrumbs, 0), offset, sizeof crumb, &crumb);
    const VkMemoryBarrier toHost{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT,
                                 VK_ACCESS_HOST_READ_BIT};
    context.vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &toHost,
                                  0, nullptr, 0, nullptr);
}

void View::recordStep(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, const Variant& variant, size_t number,
                      uint32_t slot, VkCommandBuffer commands) {
    const Step& step = steps[number];
    const size_t index = step.pass;
    const Pass& pass = plan.passes[index];
    const DeviceTable& vk = context.vk;
    if (vk.CmdBeginDebugUtilsLabelEXT) {
        const std::string text = "agaa " + pass.name;
        const VkDebugUtilsLabelEXT label{VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT, nullptr, text.c_str(), {}};
        vk.CmdBeginDebugUtilsLabelEXT(commands, &label);
    }
    StepBarriers& before = barriers[number];
    recordBarriers(vk, commands, before, outputs_);
    const Breadcrumb crumb{frame.frameIndex, step.pass, step.batch};
    const bool marks = plan.breadcrumbs != noResource;
    if (marks)
        recordBreadcrumb(offsetof(BreadcrumbBuffer, begun), crumb, commands);
    const uint32_t query = uint32_t(2 * (slot * steps.size() + number));
    if (queries)
        vk.CmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries, query);
    AgaaResult result = AGAA_OK;
    switch (pass.kind()) {
    case PassKind::HostDraw:
        beginHostRendering(context, pass, targetExtent(plan, pass, extentOf(frame, plan)), hostPasses[index],
                           passes[index].target, *resources, commands);
        if (context.secondary)
            vk.CmdExecuteCommands(commands, 1, &slots[slot].secondaries[index]);
        else
            result = callHost(frame, step, slot, commands);
        endHostRendering(context, passes[index].target, commands);
        break;
    case PassKind::Compute:
        beginCondition(step, slot, commands);
        recordCompute(vkFrame, variant, index, extentOf(frame, plan), slot, commands);
        endCondition(step, commands);
        break;
    case PassKind::Fill:
    case PassKind::Copy:
        recordTransfer(pass, frame.frameIndex, slot, commands);
        break;
    }
    if (queries)
        vk.CmdWriteTimestamp(commands, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries, query + 1);
    releaseOutputs(vk, commands, before, outputs_);
    if (marks && result == AGAA_OK) {
        // The pass ends before the write, and the write before those of the next pass.
        const VkMemoryBarrier passEnds{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_MEMORY_WRITE_BIT,
                                       VK_ACCESS_TRANSFER_WRITE_BIT};
        vk.CmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 1,
                              &passEnds, 0, nullptr, 0, nullptr);
        recordBreadcrumb(offsetof(BreadcrumbBuffer, ended), crumb, commands);
    }
    if (vk.CmdEndDebugUtilsLabelEXT)
        vk.CmdEndDebugUtilsLabelEXT(commands);
    if (result != AGAA_OK)
        failDraw(AGAA_ERROR_PARTIAL, result, pass, "discard the command buffer");
}

void View::recordPasses(const AgaaFrame& frame, const AgaaVkFrame& vkFrame, const Variant& variant, uint32_t slot,
                        bool begins) {
    const auto commands = static_cast<VkCommandBuffer>(vkFrame.commandBuffer);
    if (begins && queries)
        context.vk.CmdResetQueryPool(commands, queries, uint32_t(2 * slot * steps.size()), uint32_t(2 * steps.size()));
    if (begins && needsClear(frame)) {
        clearPersistent(commands);
        clearedIn_ = frame.frameIndex;
        isCleared_ = false;
    }
    for (size_t number = 0; number < steps.size(); ++number)
        if (plan.passes[steps[number].pass].segment & frame.segments)
            recordStep(frame, vkFrame, variant, number, slot, commands);
}

// Throws the exception at hand as AGAA_ERROR_PARTIAL.
[[noreturn]] static void rethrowAsPartial() {
    try {
        throw;
    } catch (const Error& error) {
        failPartial(error.message.c_str());
    } catch (const std::bad_alloc&) {
        failPartial("host memory is exhausted; discard the command buffer.");
    } catch (...) {
        failPartial("an unexpected internal failure; discard the command buffer.");
    }
}

AgaaResult View::record(AgaaFrame frame, const AgaaVkFrame& vkFrame) {
    AgaaSceneFacts facts;
    checkFrame(frame, facts);
    const bool begins = sequence.begins(frame);
    const uint32_t slot = sequence.slotOf(frame);
    checkTarget(frame, vkFrame);
    const Variant& variant = variantOf(frame);
    uploadFrame(frame, slot);
    writeImportedDescriptors(frame, vkFrame, slot);
    if (context.secondary)
        recordSecondaries(frame, slot);
    // Failures before this line leave the host's command buffer as it was.
    try {
        recordPasses(frame, vkFrame, variant, slot, begins);
    } catch (...) {
        // The host discards the command buffer: a frame that it begins never runs, and a frame with earlier segments
        // cannot continue.
        sequence.failed(frame);
        discardClear(frame);
        rethrowAsPartial();
    }
    // The device has finished with the slot. If the host discards the commands, no stamp will follow this 0.
    if (begins && plan.stamps != noResource)
        std::memset(resources->mapped(plan.stamps, slot) + plan.stampOffset, 0, sizeof(uint32_t));
    recorded(frame);
    return AGAA_OK;
}

} // namespace agaa::vk
