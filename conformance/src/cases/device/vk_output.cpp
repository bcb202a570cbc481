// The output on Vulkan: layouts before and after, kept contents, and both recording modes.
#include "cases.h"
#include "frame_rig.h"

#include <vulkan/vulkan.h>

namespace agaa::conformance {

namespace {

void toLayout(const AgaaVkFrame& frame, VkImageLayout from, VkImageLayout to) {
    VkImageMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = (VkImage)frame.outputImage;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    // The barrier makes no writes available, because the SDK's output is visible to all later commands.
    vkCmdPipelineBarrier(static_cast<VkCommandBuffer>(frame.commandBuffer), VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                         VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

// Passes the output to the SDK in one layout and receives it in another one. The host's layout is GENERAL.
RecordHook withLayouts(VkImageLayout in, VkImageLayout out) {
    return [in, out](const RecordCall& call, AgaaView view, const AgaaFrame* frame, const void* native) {
        AgaaVkFrame copy = *static_cast<const AgaaVkFrame*>(native);
        copy.outputLayoutIn = uint32_t(in);
        copy.outputLayoutOut = uint32_t(out);
        if (in != VK_IMAGE_LAYOUT_UNDEFINED && in != VK_IMAGE_LAYOUT_GENERAL)
            toLayout(copy, VK_IMAGE_LAYOUT_GENERAL, in);
        const AgaaResult result = call(view, frame, &copy);
        if (result == AGAA_OK && out != VK_IMAGE_LAYOUT_GENERAL)
            toLayout(copy, out, VK_IMAGE_LAYOUT_GENERAL);
        return result;
    };
}

const VkImageLayout layouts[] = {VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                                 VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

void testLayouts(Test& test, const char* technique) {
    Rig rig(test, [&](ViewDescription& description) { setTechnique(description, technique, 4); });
    const Image expected = rig.render();
    std::vector<VkImageLayout> before(std::begin(layouts), std::end(layouts));
    before.push_back(VK_IMAGE_LAYOUT_UNDEFINED);
    for (const VkImageLayout in : before)
        for (const VkImageLayout out : layouts) {
            AgaaFrame frame = rig.nextFrame();
            const std::string what = rig.function() + " with outputLayoutIn = " + std::to_string(in) +
                                     ", outputLayoutOut = " + std::to_string(out) + ", \"" + technique + "\"";
            test.requireOk(rig.record(frame, withLayouts(in, out)), what);
            rig.expectNoMessages(what);
            expectSame(test, rig.device().readOutput(), expected, 32, what);
            rig.expectNoMessages(what);
        }
}

void testWrongLayouts(Test& test) {
    Rig rig(test);
    const Image expected = rig.render();
    for (const VkImageLayout out : {VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_PREINITIALIZED}) {
        AgaaFrame frame = rig.nextFrame();
        expectFrameRefused(rig, frame,
                           {AGAA_ERROR_OUT_OF_RANGE, rig.function() + " with outputLayoutOut = " + std::to_string(out),
                            "outputLayoutOut"},
                           expected,
                           [out](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
                               AgaaVkFrame copy = *static_cast<const AgaaVkFrame*>(native);
                               copy.outputLayoutOut = uint32_t(out);
                               return call(view, f, &copy);
                           });
    }
}

void composite(ViewDescription& description) { description.desc.flags |= AGAA_VIEW_COMPOSITE; }

// A frame that keeps the contents cannot discard them.
void testDiscarded(Test& test) {
    Rig rig(test, composite);
    const Image expected = rig.render();
    AgaaFrame frame = rig.nextFrame();
    frame.background[3] = 0;
    expectFrameRefused(rig, frame,
                       {AGAA_ERROR_OUT_OF_RANGE,
                        rig.function() + " with background[3] = 0 and outputLayoutIn = UNDEFINED", "outputLayoutIn"},
                       expected, withLayouts(VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL));
}

// Frames that are recorded inline show the same image.
void testRecordingModes(Test& test) {
    for (const std::string technique : {"agaa", "msaa", "ssaa", "dcaa"}) { // two draw passes, or one
        if (!unsupportedReason(test, technique).empty())
            continue;
        Image images[2];
        for (const uint32_t recording : {AGAA_VK_RECORDING_SECONDARY, AGAA_VK_RECORDING_INLINE}) {
            Rig rig(
                test, [&](ViewDescription& description) { setTechnique(description, technique, 4); },
                [recording](ContextDescription& c) { c.vk.recording = recording; });
            rig.render();
            images[recording] = rig.render();
        }
        expectSame(test, images[AGAA_VK_RECORDING_INLINE], images[AGAA_VK_RECORDING_SECONDARY], 32,
                   "a frame of \"" + technique + "\" with AGAA_VK_RECORDING_INLINE");
    }
}

struct CommandBuffers {
    Device& device;
    std::vector<void*> received;
    static AgaaResult AGAA_CALL draw(void* user, const AgaaDrawTarget* target) {
        auto& self = *static_cast<CommandBuffers*>(user);
        self.received.push_back(target->commandBuffer);
        return self.device.draw(*target);
    }
};

void testCommandBuffers(Test& test) {
    for (const uint32_t recording : {AGAA_VK_RECORDING_SECONDARY, AGAA_VK_RECORDING_INLINE}) {
        Rig rig(test, {}, [recording](ContextDescription& c) { c.vk.recording = recording; });
        CommandBuffers buffers{rig.device(), {}};
        void* hostCommands = nullptr;
        AgaaFrame frame = rig.nextFrame();
        frame.draw = CommandBuffers::draw;
        frame.drawUser = &buffers;
        test.requireOk(rig.record(frame,
                                  [&](const RecordCall& call, AgaaView view, const AgaaFrame* f, const void* native) {
                                      hostCommands = static_cast<const AgaaVkFrame*>(native)->commandBuffer;
                                      return call(view, f, native);
                                  }),
                       rig.function());
        test.check(!buffers.received.empty(), "no draw callback is called.");
        for (void* received : buffers.received)
            test.check((received == hostCommands) == (recording == AGAA_VK_RECORDING_INLINE),
                       recording == AGAA_VK_RECORDING_INLINE
                           ? "a draw callback receives another command buffer than the host's with INLINE."
                           : "a draw callback receives the host's command buffer with SECONDARY.");
    }
}

} // namespace

void addVkOutputCases(Suite& suite) {
    const std::vector<Backend> vk = {Backend::Vulkan};
    for (const char* technique : {"agaa", "fxaa", "msaa", "dcaa"})
        suite.add("general/output_layouts/" + std::string(technique), vk,
                  [technique](Test& test) { testLayouts(test, technique); });
    suite.add("agaaVkRecordFrame/AGAA_ERROR_OUT_OF_RANGE/layouts", vk, testWrongLayouts);
    suite.add("agaaVkRecordFrame/AGAA_ERROR_OUT_OF_RANGE/discarded_contents", vk, testDiscarded);
    suite.add("general/both_ways_to_record_give_the_same_image", vk, testRecordingModes);
    suite.add("general/command_buffers_of_draw_callbacks", vk, testCommandBuffers);
}

} // namespace agaa::conformance
