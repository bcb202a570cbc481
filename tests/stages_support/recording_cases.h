// The slots of frames in flight, statistics and shadow maps. Each graphics API instantiates these for its host. The
// conformance suite tests frames that are refused.
#pragma once

#include "host_bench.h"

#include "core/plan/gpu_layout.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <stdexcept>

namespace agaa::test {

template <class Host> typename Host::Options inFlight(uint32_t frames) {
    return Host::changed([=](auto& desc) { desc.framesInFlight = frames; });
}

inline AgaaResult AGAA_CALL throwingDraw(void*, const AgaaDrawTarget*) { throw std::runtime_error("from a draw"); }

template <class Host> class RecordingCases : public testing::Test {};
TYPED_TEST_SUITE_P(RecordingCases);

// The API's struct may have more maps than the frame has shadows. They are not used, except the first declared map of
// Vulkan.
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

// A map shadows points in front of its eye only. Behind it, where w < 0, the division would read the mirrored map.
TYPED_TEST_P(RecordingCases, HardCase41PointsBehindTheEyeOfAMapAreLit) {
    BenchOf<TypeParam> bench;
    bench.shadow = shadowAt(0.75f);
    const std::vector<float> shadowed = bench.picture();
    bench.shadow.matrices[0][14] = -0.75f;
    bench.shadow.matrices[0][15] = -1;
    const std::vector<float> behind = bench.picture();
    bench.shadow.matrices[0][15] = 0;
    const std::vector<float> atTheEye = bench.picture();
    bench.light.shadowMap = AGAA_NO_SHADOW;
    const std::vector<float> lit = bench.picture();
    EXPECT_NE(shadowed, lit);
    EXPECT_EQ(behind, lit);
    EXPECT_EQ(atTheEye, lit);
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
            triangle.material.diffuse.y = std::numeric_limits<float>::quiet_NaN();
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

REGISTER_TYPED_TEST_SUITE_P(RecordingCases, OnlyTheFramesShadowMapsAreUsed, HardCase41PointsBehindTheEyeOfAMapAreLit,
                            FramesInFlightAreARing, StatisticsWaitForACompletedFrame,
                            CountsOfFragmentsCarryIntoTheirHighWord);

} // namespace agaa::test
