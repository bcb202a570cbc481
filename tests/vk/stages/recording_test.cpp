// Misuse of a real context: an error code, one clear sentence, nothing recorded, nothing lost.
#include "stage_host.h"

#include "frame_misuse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <set>
#include <stdexcept>

namespace agaa::test {
namespace {

ViewSettings settings() {
    ViewSettings s;
    s.config.samples = 4;
    s.config.flags = AGAA_CONFIG_COUNTERS;
    return s;
}

struct Bench {
    StageContext context;
    StageView view;
    ShadowLayers shadow{{1.0f}, 4};
    AgaaShadow map{};
    AgaaLight light{};

    explicit Bench(const HostOptions& options = {}) : context(options), view(context, settings()) {
        view.setTriangles(randomTriangles({.triangles = 20}, 41));
        map.layerCount = 1;
        for (int i = 0; i < 4; ++i)
            map.matrices[0][5 * i] = 1;
        light.type = AGAA_LIGHT_DIRECTIONAL;
        light.direction[2] = -1;
        light.color[0] = 1;
    }
    AgaaFrame frame() {
        AgaaFrame f = view.frame();
        f.lights = &light;
        f.lightCount = 1;
        f.shadows = &map;
        f.shadowCount = 1;
        return f;
    }
    AgaaResult record(AgaaFrame& frame, AgaaVkFrame& vk) {
        context.lines.clear();
        return agaaVkRecordFrame(view.get(), &frame, &vk);
    }
    // A complete frame of its own, to see that the view still works.
    void renderGoodFrame() {
        view.render(frame(), [&](AgaaVkFrame& vk) { vk.shadowViews[0] = shadow.view(); });
        EXPECT_GT(view.statistics().counters.visible, 0u);
    }
    void expectOneSentence(AgaaResult code, const char* what) { test::expectOneSentence(context.lines, code, what); }
};

// What lies in AgaaVkFrame beyond the frame's shadows is not used, but for the first declared map.
TEST(Recording, OnlyTheFramesShadowMapsAreUsed) {
    StageContext context;
    ViewSettings two = settings();
    two.facts.shadowMapCount = 2;
    StageView view(context, two);
    view.setTriangles(randomTriangles({.triangles = 20}, 41));
    const ShadowLayers shadow{{1.0f}, 4};
    view.render(view.frame(), [&](AgaaVkFrame& vk) {
        vk.shadowViews[0] = shadow.view();
        vk.shadowViews[1] = ~uint64_t{0} - 5; // no view
    });
    EXPECT_GT(view.statistics().counters.visible, 0u);
}

struct Row {
    const char* what;
    AgaaResult expected;
    std::function<void(AgaaFrame&, AgaaVkFrame&, Bench&)> spoil;
};

const Row rows[] = {
    {"backend: wrong structSize", AGAA_ERROR_STRUCT,
     [](auto&, auto& vk, auto&) { vk.structSize = 0; }},
    {"backend: unknown struct", AGAA_ERROR_UNKNOWN_STRUCT,
     [](auto&, auto& vk, auto&) { vk.pNext = &unknownStruct; }},
    {"no command buffer", AGAA_ERROR_INVALID_ARGUMENT,
     [](auto&, auto& vk, auto&) { vk.commandBuffer = nullptr; }},
    {"no output image", AGAA_ERROR_INVALID_ARGUMENT,
     [](auto&, auto& vk, auto&) { vk.outputImage = 0; }},
    {"no output view", AGAA_ERROR_INVALID_ARGUMENT,
     [](auto&, auto& vk, auto&) { vk.outputView = 0; }},
    {"output left in no layout", AGAA_ERROR_OUT_OF_RANGE,
     [](auto&, auto& vk, auto&) { vk.outputLayoutOut = VK_IMAGE_LAYOUT_UNDEFINED; }},
    {"composites without the view's flag", AGAA_ERROR_OUT_OF_RANGE,
     [](auto& f, auto& vk, auto&) {
         f.background[3] = 0;
         vk.outputLayoutIn = VK_IMAGE_LAYOUT_GENERAL;
     }},
    {"no shadow view", AGAA_ERROR_INVALID_ARGUMENT,
     [](auto&, auto& vk, auto&) { vk.shadowViews[0] = 0; }},
};

// A refused frame leaves an empty command buffer, which runs without a message of validation; the next
// frame is as good as ever.
TEST(Recording, MisuseIsRefusedAndChangesNothing) {
    Bench bench;
    bench.renderGoodFrame();
    const std::vector<float> expected = bench.view.image().rgb;
    const AgaaShadow map = bench.map;
    const AgaaLight light = bench.light;
    std::vector<Row> all(std::begin(rows), std::end(rows));
    for (const FrameMisuse& misuse : frameMisuses)
        all.push_back({misuse.what, misuse.expected, [&](auto& frame, auto&, auto& b) {
                           misuse.spoil(frame, b.light, b.map);
                       }});
    for (const Row& row : all) {
        bench.view.drawCalls = 0;
        sharedDevice().runCommands([&](VkCommandBuffer commands) {
            AgaaFrame frame = bench.frame();
            AgaaVkFrame vk = bench.view.vkFrame(commands);
            vk.shadowViews[0] = bench.shadow.view();
            row.spoil(frame, vk, bench);
            EXPECT_EQ(bench.record(frame, vk), row.expected) << row.what;
            bench.expectOneSentence(row.expected, row.what);
        });
        EXPECT_EQ(bench.view.drawCalls, 0u) << row.what;
        bench.map = map;
        bench.light = light;
    }
    bench.renderGoodFrame();
    EXPECT_EQ(bench.view.image().rgb, expected);
}

TEST(Recording, NullPointersAreRefused) {
    Bench bench;
    AgaaFrame frame = bench.frame();
    AgaaVkFrame vk = bench.view.vkFrame(nullptr);
    EXPECT_EQ(agaaVkRecordFrame(nullptr, &frame, &vk), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaVkRecordFrame(bench.view.get(), nullptr, &vk), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaVkRecordFrame(bench.view.get(), &frame, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaVkGetDrawPasses(bench.view.get(), nullptr, nullptr),
              AGAA_ERROR_INVALID_ARGUMENT);
    uint32_t count = 0;
    EXPECT_EQ(agaaVkGetDrawPasses(nullptr, &count, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 1, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    AgaaVkDrawPass small = AGAA_VK_DRAW_PASS_INIT;
    count = 1;
    EXPECT_EQ(agaaVkGetDrawPasses(bench.view.get(), &count, &small), AGAA_ERROR_BUFFER_TOO_SMALL);
    AgaaVkDrawPass passes[2] = {AGAA_VK_DRAW_PASS_INIT, AGAA_VK_DRAW_PASS_INIT};
    passes[1].structSize = 1;
    count = 2;
    EXPECT_EQ(agaaVkGetDrawPasses(bench.view.get(), &count, passes), AGAA_ERROR_STRUCT);
}

// Draw callbacks fail in either pass. With secondary recording the host's command buffer stays empty.
TEST(Recording, AFailingCallbackRecordsNothing) {
    Bench bench;
    bench.renderGoodFrame();
    const std::vector<float> expected = bench.view.image().rgb;
    for (uint32_t pass : {AGAA_DRAW_PASS_VISIBILITY, AGAA_DRAW_PASS_AGGREGATE}) {
        bench.view.drawResults[pass] = -77;
        sharedDevice().runCommands([&](VkCommandBuffer commands) {
            AgaaFrame frame = bench.frame();
            AgaaVkFrame vk = bench.view.vkFrame(commands);
            vk.shadowViews[0] = bench.shadow.view();
            EXPECT_EQ(bench.record(frame, vk), AGAA_ERROR_CALLBACK);
            bench.expectOneSentence(AGAA_ERROR_CALLBACK, "callback");
            EXPECT_NE(bench.context.lines[0].text.find("-77"), std::string::npos);
            // The same frame can be recorded after all.
            bench.view.drawResults.clear();
            EXPECT_EQ(bench.record(frame, vk), AGAA_OK);
        });
        EXPECT_EQ(bench.view.image().rgb, expected);
    }
}

TEST(Recording, AFailingCallbackInlineIsPartial) {
    Bench bench({.inlineRecording = true});
    bench.renderGoodFrame();
    const std::vector<float> expected = bench.view.image().rgb;
    bench.view.drawResults[AGAA_DRAW_PASS_AGGREGATE] = 5;
    const VkCommandBuffer commands = sharedDevice().beginCommands();
    AgaaFrame frame = bench.frame();
    AgaaVkFrame vk = bench.view.vkFrame(commands);
    vk.shadowViews[0] = bench.shadow.view();
    EXPECT_EQ(bench.record(frame, vk), AGAA_ERROR_PARTIAL);
    bench.expectOneSentence(AGAA_ERROR_PARTIAL, "inline");
    sharedDevice().discardCommands(commands);
    bench.view.drawResults.clear();
    bench.renderGoodFrame();
    EXPECT_EQ(bench.view.image().rgb, expected);
}

AgaaResult AGAA_CALL throwing(void*, const AgaaDrawTarget*) { throw std::runtime_error("from a callback"); }

// The contract forbids it, but the SDK can still end what it began.
TEST(Recording, ACallbackThatThrowsHasFailed) {
    for (bool isInline : {false, true}) {
        SCOPED_TRACE(isInline);
        const AgaaResult expectedCode = isInline ? AGAA_ERROR_PARTIAL : AGAA_ERROR_CALLBACK;
        Bench bench({.inlineRecording = isInline});
        bench.renderGoodFrame();
        const std::vector<float> expected = bench.view.image().rgb;
        const VkCommandBuffer commands = sharedDevice().beginCommands();
        AgaaFrame frame = bench.frame();
        frame.draw = throwing;
        AgaaVkFrame vk = bench.view.vkFrame(commands);
        vk.shadowViews[0] = bench.shadow.view();
        EXPECT_EQ(bench.record(frame, vk), expectedCode);
        bench.expectOneSentence(expectedCode, "throwing callback");
        sharedDevice().discardCommands(commands);
        bench.renderGoodFrame();
        EXPECT_EQ(bench.view.image().rgb, expected);
    }
}

// A device whose dispatches throw what the library does not.
bool dispatchThrows = false;
PFN_vkCmdDispatch realDispatch = nullptr;
PFN_vkGetDeviceProcAddr realDeviceProcAddr = nullptr;

VKAPI_ATTR void VKAPI_CALL dispatch(VkCommandBuffer commands, uint32_t x, uint32_t y, uint32_t z) {
    if (dispatchThrows)
        throw std::runtime_error("from the driver");
    realDispatch(commands, x, y, z);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL deviceProcAddr(VkDevice device, const char* name) {
    const PFN_vkVoidFunction real = realDeviceProcAddr(device, name);
    if (std::strcmp(name, "vkCmdDispatch") != 0)
        return real;
    realDispatch = reinterpret_cast<PFN_vkCmdDispatch>(real);
    return reinterpret_cast<PFN_vkVoidFunction>(dispatch);
}

AgaaVkFunction AGAA_CALL procAddr(void* instance, const char* name) {
    const AgaaVkFunction real = harness::vk::Device::getProcAddr(instance, name);
    if (std::strcmp(name, "vkGetDeviceProcAddr") != 0)
        return real;
    realDeviceProcAddr = reinterpret_cast<PFN_vkGetDeviceProcAddr>(real);
    return reinterpret_cast<AgaaVkFunction>(deviceProcAddr);
}

TEST(Recording, AnyFailureAfterTheFirstCommandIsPartial) {
    Bench bench({.getProcAddr = procAddr});
    bench.renderGoodFrame();
    const std::vector<float> expected = bench.view.image().rgb;
    AgaaFrame frame = bench.frame();
    frame.segments = AGAA_SEGMENT_PREPASS;
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        AgaaVkFrame vk = bench.view.vkFrame(commands);
        ASSERT_EQ(bench.record(frame, vk), AGAA_OK);
    });
    frame.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
    const VkCommandBuffer commands = sharedDevice().beginCommands();
    AgaaVkFrame vk = bench.view.vkFrame(commands);
    vk.shadowViews[0] = bench.shadow.view();
    dispatchThrows = true;
    EXPECT_EQ(bench.record(frame, vk), AGAA_ERROR_PARTIAL);
    dispatchThrows = false;
    bench.expectOneSentence(AGAA_ERROR_PARTIAL, "unexpected");
    // Earlier segments of the frame have run, so that it cannot go on.
    EXPECT_EQ(bench.record(frame, vk), AGAA_ERROR_WRONG_ORDER);
    sharedDevice().discardCommands(commands);
    bench.renderGoodFrame();
    EXPECT_EQ(bench.view.image().rgb, expected);
}

TEST(Recording, FramesAndSegmentsHaveAnOrder) {
    Bench bench;
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        AgaaVkFrame vk = bench.view.vkFrame(commands);
        vk.shadowViews[0] = bench.shadow.view();
        AgaaFrame first = bench.frame();
        first.segments = AGAA_SEGMENT_PREPASS;
        EXPECT_EQ(bench.record(first, vk), AGAA_OK);
        EXPECT_EQ(bench.record(first, vk), AGAA_ERROR_WRONG_ORDER) << "twice";
        first.segments = AGAA_SEGMENT_SHADING;
        EXPECT_EQ(bench.record(first, vk), AGAA_ERROR_WRONG_ORDER) << "one left out";
        first.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
        AgaaFrame elsewhere = first;
        elsewhere.projection[0] *= 2;
        EXPECT_EQ(bench.record(elsewhere, vk), AGAA_ERROR_OUT_OF_RANGE) << "another camera";
        bench.expectOneSentence(AGAA_ERROR_OUT_OF_RANGE, "another camera");
        AgaaFrame otherDither = first;
        ++otherDither.ditherFrame;
        EXPECT_EQ(bench.record(otherDither, vk), AGAA_ERROR_OUT_OF_RANGE) << "another ditherFrame";
        bench.expectOneSentence(AGAA_ERROR_OUT_OF_RANGE, "another ditherFrame");
        EXPECT_EQ(bench.record(first, vk), AGAA_OK);
        AgaaFrame again = first;
        again.segments = AGAA_SEGMENT_ALL;
        EXPECT_EQ(bench.record(again, vk), AGAA_ERROR_WRONG_ORDER) << "the same frame";
        again.frameIndex = 0;
        again.completedFrame = 0;
        EXPECT_EQ(bench.record(again, vk), AGAA_ERROR_OUT_OF_RANGE) << "before the first frame";
        AgaaFrame second = bench.frame();
        second.completedFrame = 0;
        EXPECT_EQ(bench.record(second, vk), AGAA_OK) << "two in flight";
        again.frameIndex = 1;
        EXPECT_EQ(bench.record(again, vk), AGAA_ERROR_WRONG_ORDER) << "an earlier frame";
        AgaaFrame third = bench.frame();
        third.completedFrame = 0;
        EXPECT_EQ(bench.record(third, vk), AGAA_ERROR_WRONG_ORDER) << "three in flight";
        bench.expectOneSentence(AGAA_ERROR_WRONG_ORDER, "in flight");
    });
    bench.renderGoodFrame();
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

// The device may run a segment while the next one, which brings other light, is recorded.
TEST(Recording, SegmentsLeaveTheConstantsOfEarlierOnesAlone) {
    Bench bench;
    bench.renderGoodFrame();
    const std::vector<float> expected = bench.view.image().rgb;
    AgaaFrame frame = bench.frame();
    const AgaaFrame lit = frame;
    std::set<size_t> written;
    frame.lightCount = 0;
    frame.background[1] = 0.25f;
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        AgaaVkFrame vk = bench.view.vkFrame(commands);
        vk.shadowViews[0] = bench.shadow.view();
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
    EXPECT_EQ(bench.view.image().rgb, expected);
}

// Fragments add to the low word of a count, which has a high word too. The test puts the low word near its end after
// the first segment, which clears it.
TEST(Recording, CountsOfFragmentsCarryIntoTheirHighWord) {
    Bench bench;
    std::vector<Triangle> triangles = randomTriangles({.triangles = 20}, 41);
    for (Triangle& triangle : triangles)
        triangle.material.diffuse.y = nan;
    bench.view.setTriangles(triangles);
    bench.renderGoodFrame();
    const uint64_t once = bench.view.statistics().counters.sanitised;
    ASSERT_GT(once, 2u);
    const uint32_t start = 0xFFFFFFFEu;
    const std::vector<agaa::Resource>& resources = bench.view.plan().resources;
    const auto counters = std::find_if(resources.begin(), resources.end(),
                                       [](const agaa::Resource& r) { return r.name == "counters"; });
    const VkBuffer buffer = (*bench.view.executor().resources)[agaa::ResourceId(counters - resources.begin())].buffers[0];
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        AgaaFrame frame = bench.frame();
        AgaaVkFrame vk = bench.view.vkFrame(commands);
        vk.shadowViews[0] = bench.shadow.view();
        frame.segments = AGAA_SEGMENT_PREPASS;
        ASSERT_EQ(bench.record(frame, vk), AGAA_OK);
        VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_MEMORY_WRITE_BIT,
                                VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT};
        const auto wait = [&] {
            vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 1,
                                 &barrier, 0, nullptr, 0, nullptr);
        };
        wait();
        vkCmdUpdateBuffer(commands, buffer, offsetof(agaa::CounterBuffer, counts[agaa::AGAA_COUNT_SANITISED]), sizeof start, &start);
        wait();
        frame.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
        ASSERT_EQ(bench.record(frame, vk), AGAA_OK);
    });
    EXPECT_EQ(bench.view.statistics().counters.sanitised, start + once);
}

// What was begun and given up does not stop the next frame.
TEST(Recording, AnUnfinishedFrameCanBeLeft) {
    Bench bench;
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        AgaaVkFrame vk = bench.view.vkFrame(commands);
        AgaaFrame frame = bench.frame();
        frame.segments = AGAA_SEGMENT_PREPASS;
        vk.shadowViews[0] = bench.shadow.view();
        EXPECT_EQ(bench.record(frame, vk), AGAA_OK);
    });
    bench.renderGoodFrame();
}

TEST(Recording, StatisticsWaitForACompletedFrame) {
    Bench bench;
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 0, &statistics), AGAA_NOT_READY);
    bench.renderGoodFrame();
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 0, &statistics), AGAA_NOT_READY);
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 1, &statistics), AGAA_OK);
    EXPECT_EQ(statistics.frameIndex, 1u);
    EXPECT_EQ(statistics.geometryPasses, 2u);
    EXPECT_GT(statistics.payloadBytes, 0u);
    EXPECT_GE(statistics.driverBytes, statistics.payloadBytes);
    statistics.structSize = 4;
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 1, &statistics), AGAA_ERROR_STRUCT);
}

} // namespace
} // namespace agaa::test
