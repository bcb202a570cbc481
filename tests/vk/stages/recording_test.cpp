// The recording of frames by Vulkan: what all graphics APIs share, and what command buffers add.
#include "dispatch_hook.h"
#include "recording_cases.h"
#include "show.h"

#include <set>

namespace agaa::test {
namespace {

struct RecordingHost : VulkanHost {
    static constexpr bool driverTellsBytes = true;
    static std::vector<HostOptions> storages() { return {HostOptions{}}; }
    static void spoilSecondMap(AgaaVkFrame& frame) { frame.shadowViews[1] = ~uint64_t{0} - 5; } // no view

    static void setCounter(const StageView& view, const AgaaVkFrame& frame, size_t offset, uint32_t value) {
        const auto commands = static_cast<VkCommandBuffer>(frame.commandBuffer);
        const VkBuffer buffer = (*view.executor().resources)[findResource(view.plan(), "counters")].buffers[0];
        const VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_MEMORY_WRITE_BIT,
                                      VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};
        const auto wait = [&] {
            vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1,
                                 &barrier, 0, nullptr, 0, nullptr);
        };
        wait();
        vkCmdUpdateBuffer(commands, buffer, offset, sizeof value, &value);
        wait();
    }
};
INSTANTIATE_TYPED_TEST_SUITE_P(Vulkan, RecordingCases, RecordingHost);

struct Bench : BenchOf<VulkanHost> {
    explicit Bench(const HostOptions& options = {}) : BenchOf(benchSettings(), options) {}
    AgaaVkFrame vkFrame(VkCommandBuffer commands) {
        AgaaVkFrame frame = view.vkFrame(commands);
        frame.shadowViews[0] = map.view();
        return frame;
    }
};

// A dispatch throws what the library does not.
TEST(VkRecording, AnyFailureAfterTheFirstCommandIsPartial) {
    Bench bench({.getProcAddr = DispatchHook::procAddr});
    const std::vector<float> expected = bench.picture();
    AgaaFrame frame = bench.frame();
    frame.segments = AGAA_SEGMENT_PREPASS;
    bench.render(frame);
    frame.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
    const VkCommandBuffer commands = sharedDevice().beginCommands();
    const AgaaVkFrame vk = bench.vkFrame(commands);
    DispatchHook::before = [](VkCommandBuffer) { throw std::runtime_error("from the driver"); };
    EXPECT_EQ(bench.record(frame, vk), AGAA_ERROR_PARTIAL);
    DispatchHook::before = nullptr;
    expectOneSentence(bench.context.lines, AGAA_ERROR_PARTIAL, "unexpected");
    // Earlier segments of the frame have run, so that it cannot go on.
    EXPECT_EQ(bench.record(frame, vk), AGAA_ERROR_WRONG_ORDER);
    sharedDevice().discardCommands(commands);
    EXPECT_EQ(bench.picture(), expected);
}

// The frame constants of every segment and frame in flight.
std::vector<std::vector<std::byte>> uploads(const StageView& view) {
    std::vector<std::vector<std::byte>> copies;
    for (agaa::ResourceId id = 0; id < view.plan().resources.size(); ++id) {
        const agaa::Resource& resource = view.plan().resources[id];
        if (resource.content != agaa::UploadContent::FrameConstants)
            continue;
        for (const void* mapped : (*view.executor().resources)[id].mapped) {
            const auto* bytes = static_cast<const std::byte*>(mapped);
            copies.emplace_back(bytes, bytes + resource.bytes);
        }
    }
    return copies;
}

// On Vulkan the device may run a segment while the next one, which brings other light, is recorded.
TEST(VkRecording, SegmentsLeaveTheConstantsOfEarlierOnesAlone) {
    Bench bench;
    const std::vector<float> expected = bench.picture();
    AgaaFrame frame = bench.frame();
    const AgaaFrame lit = frame;
    std::set<size_t> written;
    frame.lightCount = 0;
    frame.background[1] = 0.25f;
    bench.run([&](const AgaaVkFrame& vk) {
        for (uint64_t segment : {AGAA_SEGMENT_PREPASS, AGAA_SEGMENT_GENERATION, AGAA_SEGMENT_SHADING}) {
            if (segment == AGAA_SEGMENT_SHADING)
                frame = lit;
            frame.segments = segment;
            const auto before = uploads(bench.view);
            ASSERT_EQ(bench.record(frame, vk), AGAA_OK);
            const auto after = uploads(bench.view);
            for (size_t i = 0; i < after.size(); ++i)
                if (after[i] != before[i]) {
                    EXPECT_TRUE(written.insert(i).second) << "segment " << segment << " changes what another wrote";
                }
        }
    });
    EXPECT_EQ(bench.image(), expected);
}

} // namespace
} // namespace agaa::test
