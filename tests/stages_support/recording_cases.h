// Misuse of frames: an error code, one clear sentence, nothing drawn, nothing lost; and the order of frames and
// segments. Each graphics API instantiates these for its host, with how contexts and frames of its own are spoiled.
#pragma once

#include "frame_misuse.h"
#include "host_bench.h"

#include "core/plan/gpu_layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <stdexcept>

namespace agaa::test {

// Of the API's own struct.
template <class Frame>
struct NativeMisuse {
    const char* what;
    AgaaResult expected;
    std::function<void(AgaaFrame&, Frame&)> spoil;
};

template <class Host>
typename Host::Options inFlight(uint32_t frames) {
    return Host::changed([=](auto& desc) { desc.framesInFlight = frames; });
}

inline AgaaResult AGAA_CALL throwingDraw(void*, const AgaaDrawTarget*) { throw std::runtime_error("from a draw"); }

template <class Host>
class RecordingCases : public testing::Test {};
TYPED_TEST_SUITE_P(RecordingCases);

// A refused frame draws nothing; the next one is as good as ever.
TYPED_TEST_P(RecordingCases, MisuseIsRefusedAndChangesNothing) {
    using Frame = typename TypeParam::Frame;
    BenchOf<TypeParam> bench;
    const std::vector<float> expected = bench.picture();
    std::vector<NativeMisuse<Frame>> rows = TypeParam::misuses();
    rows.push_back({"backend: wrong sType", AGAA_ERROR_STRUCT, [](auto&, auto& native) { native.sType = 9; }});
    rows.push_back({"backend: wrong structSize", AGAA_ERROR_STRUCT, [](auto&, auto& native) { native.structSize = 0; }});
    rows.push_back({"backend: unknown struct", AGAA_ERROR_UNKNOWN_STRUCT,
                    [](auto&, auto& native) { native.pNext = &unknownStruct; }});
    for (const FrameMisuse& misuse : frameMisuses)
        rows.push_back({misuse.what, misuse.expected,
                        [&](auto& frame, auto&) { misuse.spoil(frame, bench.light, bench.shadow); }});
    const AgaaShadow shadow = bench.shadow;
    const AgaaLight light = bench.light;
    bench.view.drawCalls = 0;
    for (const auto& row : rows) {
        bench.run([&](Frame& native) {
            AgaaFrame frame = bench.frame();
            row.spoil(frame, native);
            EXPECT_EQ(bench.record(frame, native), row.expected) << row.what;
            expectOneSentence(bench.context.lines, row.expected, row.what);
        });
        EXPECT_EQ(bench.view.drawCalls, 0u) << row.what;
        bench.shadow = shadow;
        bench.light = light;
    }
    EXPECT_EQ(bench.image(), expected);
    TypeParam::forgetMessages();
    EXPECT_EQ(bench.picture(), expected);
}

TYPED_TEST_P(RecordingCases, NullPointersAreRefused) {
    using Frame = typename TypeParam::Frame;
    BenchOf<TypeParam> bench;
    const AgaaView view = bench.view.get();
    bench.run([&](const Frame& native) {
        const AgaaFrame frame = bench.frame();
        EXPECT_EQ(TypeParam::recordFrame(nullptr, &frame, &native), AGAA_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(TypeParam::recordFrame(view, nullptr, &native), AGAA_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(TypeParam::recordFrame(view, &frame, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    });
    EXPECT_EQ(agaaGetFrameStatistics(view, 1, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    uint32_t count = 0;
    EXPECT_EQ(agaaGetDrawPasses(view, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGetDrawPasses(nullptr, &count, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    AgaaDrawPass passes[2] = {AGAA_DRAW_PASS_INIT, AGAA_DRAW_PASS_INIT};
    const AgaaDrawPass untouched = AGAA_DRAW_PASS_INIT;
    count = 1;
    EXPECT_EQ(agaaGetDrawPasses(view, &count, passes), AGAA_ERROR_BUFFER_TOO_SMALL);
    passes[1].structSize = 1;
    count = 2;
    EXPECT_EQ(agaaGetDrawPasses(view, &count, passes), AGAA_ERROR_STRUCT);
    passes[1] = untouched;
    typename TypeParam::NativePass natives[2] = {TypeParam::nativePass, TypeParam::nativePass};
    passes[1].pNext = &natives[1];
    natives[1].structSize = 1;
    EXPECT_EQ(agaaGetDrawPasses(view, &count, passes), AGAA_ERROR_STRUCT);
    natives[1].sType = AGAA_STRUCTURE_TYPE_SURFACE;
    EXPECT_EQ(agaaGetDrawPasses(view, &count, passes), AGAA_ERROR_UNKNOWN_STRUCT);
    EXPECT_EQ(std::memcmp(&passes[0], &untouched, sizeof untouched), 0) << "nothing is written where the call fails";
    natives[1] = TypeParam::nativePass;
    EXPECT_EQ(agaaGetDrawPasses(view, &count, passes), AGAA_OK);
    EXPECT_NE(passes[0].pipelineKey, passes[1].pipelineKey);
    EXPECT_NE(natives[1].depthStencilFormat, 0u);
    EXPECT_EQ(natives[0].depthStencilFormat, 0u) << "not chained";
    AgaaSurface surface = AGAA_SURFACE_INIT;
    EXPECT_EQ(agaaGetSurface(nullptr, "depth", &surface), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGetSurface(view, nullptr, &surface), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGetSurface(view, "depth", nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGetSurface(view, "nothing", &surface), AGAA_ERROR_INVALID_ARGUMENT);
    typename TypeParam::NativeSurface native = TypeParam::nativeSurface;
    surface.pNext = &native;
    EXPECT_EQ(agaaGetSurface(view, "depth", &surface), AGAA_OK);
    EXPECT_NE(native.format, 0u);
    EXPECT_STREQ(surface.name, "depth");
    EXPECT_EQ(surface.width, 48 * surface.scaleX);
}

// What lies in the API's struct beyond the frame's shadows is not used, but for Vulkan's first declared map.
TYPED_TEST_P(RecordingCases, OnlyTheFramesShadowMapsAreUsed) {
    ViewSettings settings = benchSettings();
    settings.facts.shadowMapCount = 2;
    BenchOf<TypeParam> bench(settings);
    const std::vector<float> expected = bench.picture();
    for (uint32_t count : {1u, 0u}) {
        SCOPED_TRACE(count);
        bench.light.shadowMap = count ? 0 : AGAA_NO_SHADOW;
        AgaaFrame frame = bench.frame();
        frame.shadowCount = count;
        bench.run([&](auto& native) {
            TypeParam::spoilSecondMap(native);
            EXPECT_EQ(bench.record(frame, native), AGAA_OK);
        });
        EXPECT_GT(bench.view.statistics().counters.visible, 0u);
        if (count) {
            EXPECT_EQ(bench.image(), expected);
        }
    }
}

// Draw callbacks fail in either pass. The same frame can be recorded after all, into the same commands too.
TYPED_TEST_P(RecordingCases, AFailingCallbackRecordsNothing) {
    BenchOf<TypeParam> bench;
    const std::vector<float> expected = bench.picture();
    for (uint32_t pass : {AGAA_DRAW_PASS_VISIBILITY, AGAA_DRAW_PASS_AGGREGATE}) {
        const AgaaFrame frame = bench.frame();
        const auto fail = [&](const auto& native) {
            bench.view.drawResults[pass] = -77;
            EXPECT_EQ(bench.record(frame, native), AGAA_ERROR_CALLBACK);
            expectOneSentence(bench.context.lines, AGAA_ERROR_CALLBACK, "callback", "-77");
            bench.view.drawResults.clear();
        };
        bench.run(fail);
        EXPECT_EQ(bench.image(), expected);
        bench.run([&](const auto& native) {
            fail(native);
            EXPECT_EQ(bench.record(frame, native), AGAA_OK);
        });
        EXPECT_EQ(bench.image(), expected);
    }
}

// The contract forbids it, but the SDK can still end what it began.
TYPED_TEST_P(RecordingCases, ACallbackThatThrowsHasFailed) {
    BenchOf<TypeParam> bench;
    const std::vector<float> expected = bench.picture();
    AgaaFrame frame = bench.frame();
    frame.draw = throwingDraw;
    bench.run([&](const auto& native) {
        EXPECT_EQ(bench.record(frame, native), AGAA_ERROR_CALLBACK);
        expectOneSentence(bench.context.lines, AGAA_ERROR_CALLBACK, "throwing callback");
    });
    EXPECT_EQ(bench.image(), expected);
    EXPECT_EQ(bench.picture(), expected);
}

TYPED_TEST_P(RecordingCases, FramesAndSegmentsHaveAnOrder) {
    BenchOf<TypeParam> bench(benchSettings(), inFlight<TypeParam>(2));
    const std::vector<float> expected = bench.picture();
    bench.run([&](const auto& native) {
        const auto expect = [&](AgaaFrame frame, uint64_t segments, AgaaResult result, const char* what) {
            frame.segments = segments;
            EXPECT_EQ(bench.record(frame, native), result) << what;
            if (result != AGAA_OK)
                expectOneSentence(bench.context.lines, result, what);
        };
        const AgaaFrame frame = bench.frame();
        expect(frame, AGAA_SEGMENT_GENERATION, AGAA_ERROR_WRONG_ORDER, "begins in the middle");
        expect(frame, AGAA_SEGMENT_PREPASS, AGAA_OK, "begins");
        expect(frame, AGAA_SEGMENT_PREPASS, AGAA_ERROR_WRONG_ORDER, "twice");
        expect(frame, AGAA_SEGMENT_SHADING, AGAA_ERROR_WRONG_ORDER, "one left out");
        constexpr uint64_t rest = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
        AgaaFrame elsewhere = frame;
        elsewhere.projection[0] *= 2;
        AgaaFrame otherDither = frame;
        ++otherDither.ditherFrame;
        for (const uint64_t segments : {uint64_t(AGAA_SEGMENT_GENERATION), rest}) {
            expect(elsewhere, segments, AGAA_ERROR_OUT_OF_RANGE, "another camera");
            expect(otherDither, segments, AGAA_ERROR_OUT_OF_RANGE, "another ditherFrame");
        }
        expect(frame, rest, AGAA_OK, "the rest");
        expect(frame, AGAA_SEGMENT_ALL, AGAA_ERROR_WRONG_ORDER, "the same frame");
        AgaaFrame earlier = frame;
        --earlier.frameIndex;
        --earlier.completedFrame;
        expect(earlier, AGAA_SEGMENT_ALL, AGAA_ERROR_WRONG_ORDER, "an earlier frame");
        AgaaFrame none = frame;
        none.frameIndex = none.completedFrame = 0;
        expect(none, AGAA_SEGMENT_ALL, AGAA_ERROR_OUT_OF_RANGE, "before the first frame");
        AgaaFrame second = bench.frame();
        second.completedFrame = frame.completedFrame;
        expect(second, AGAA_SEGMENT_ALL, AGAA_OK, "two in flight");
        expect(frame, AGAA_SEGMENT_ALL, AGAA_ERROR_WRONG_ORDER, "the frame before");
        AgaaFrame third = bench.frame();
        third.completedFrame = frame.completedFrame;
        expect(third, AGAA_SEGMENT_ALL, AGAA_ERROR_WRONG_ORDER, "three in flight");
    });
    EXPECT_EQ(bench.image(), expected);
    // What was begun and given up does not stop the next frame.
    AgaaFrame left = bench.frame();
    left.segments = AGAA_SEGMENT_PREPASS;
    bench.render(left);
    EXPECT_EQ(bench.picture(), expected);
}

// The slots of frames in flight, and the statistics that they keep.
TYPED_TEST_P(RecordingCases, FramesInFlightAreARing) {
    for (const uint32_t slots : {1u, 3u, 8u}) {
        BenchOf<TypeParam> bench(benchSettings(), inFlight<TypeParam>(slots));
        const auto record = [&](uint64_t completed) {
            AgaaFrame frame = bench.frame();
            frame.completedFrame = completed;
            AgaaResult result = AGAA_ERROR_DEVICE;
            bench.run([&](const auto& native) { result = bench.record(frame, native); });
            return result;
        };
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 9, &statistics), AGAA_NOT_READY);
        EXPECT_TRUE(bench.context.lines.empty());
        std::vector<uint64_t> visible(slots + 1); // each frame shows more
        for (uint32_t i = 1; i <= slots; ++i) {
            const float width = 4 * float(i);
            bench.view.setTriangles(rectangle(-width / 48, -0.5f, width / 48, 0.5f, 2, Material{}));
            EXPECT_EQ(record(0), AGAA_OK) << i;
        }
        EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 0, &statistics), AGAA_NOT_READY);
        for (uint32_t i = 1; i <= slots; ++i) {
            EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), i, &statistics), AGAA_OK);
            EXPECT_EQ(statistics.frameIndex, i);
            visible[i] = statistics.counters.visible;
            EXPECT_GT(visible[i], visible[i - 1]);
        }
        EXPECT_EQ(record(0), AGAA_ERROR_WRONG_ORDER) << "one too many in flight";
        expectOneSentence(bench.context.lines, AGAA_ERROR_WRONG_ORDER, "in flight");
        EXPECT_EQ(record(1), AGAA_OK);
    }
}

TYPED_TEST_P(RecordingCases, StatisticsWaitForACompletedFrame) {
    BenchOf<TypeParam> bench;
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 0, &statistics), AGAA_NOT_READY);
    bench.picture();
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 0, &statistics), AGAA_NOT_READY);
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 1, &statistics), AGAA_OK);
    EXPECT_EQ(statistics.frameIndex, 1u);
    EXPECT_EQ(statistics.geometryPasses, 2u);
    EXPECT_GT(statistics.payloadBytes, 0u);
    EXPECT_GE(statistics.driverBytes, TypeParam::driverTellsBytes ? statistics.payloadBytes : 0);
    EXPECT_EQ(statistics.driverBytes > 0, TypeParam::driverTellsBytes);
    statistics.structSize = 4;
    EXPECT_EQ(agaaGetFrameStatistics(bench.view.get(), 1, &statistics), AGAA_ERROR_STRUCT);
}

// Fragments add to the low word of a count, which has a high word too. The test puts the low word near its end after
// the first segment, which clears it.
TYPED_TEST_P(RecordingCases, CountsOfFragmentsCarryIntoTheirHighWord) {
    for (const auto& options : TypeParam::storages()) {
        BenchOf<TypeParam> bench(benchSettings(), options);
        std::vector<Triangle> triangles = randomTriangles({.triangles = 20}, 41);
        for (Triangle& triangle : triangles)
            triangle.material.diffuse.y = nan;
        bench.view.setTriangles(triangles);
        bench.picture();
        const uint64_t once = bench.view.statistics().counters.sanitised;
        ASSERT_GT(once, 2u);
        const uint32_t start = 0xFFFFFFFEu;
        bench.run([&](const auto& native) {
            AgaaFrame frame = bench.frame();
            frame.segments = AGAA_SEGMENT_PREPASS;
            ASSERT_EQ(bench.record(frame, native), AGAA_OK);
            TypeParam::setCounter(bench.view, native, offsetof(CounterBuffer, counts[AGAA_COUNT_SANITISED]), start);
            frame.segments = AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING;
            ASSERT_EQ(bench.record(frame, native), AGAA_OK);
        });
        EXPECT_EQ(bench.view.statistics().counters.sanitised, start + once);
    }
}

REGISTER_TYPED_TEST_SUITE_P(RecordingCases, MisuseIsRefusedAndChangesNothing, NullPointersAreRefused,
                            OnlyTheFramesShadowMapsAreUsed, AFailingCallbackRecordsNothing, ACallbackThatThrowsHasFailed,
                            FramesAndSegmentsHaveAnOrder, FramesInFlightAreARing, StatisticsWaitForACompletedFrame,
                            CountsOfFragmentsCarryIntoTheirHighWord);

} // namespace agaa::test
