// Frames of fewer pixels than their view, and frames at a place of a larger output. Each graphics API instantiates
// these.
#pragma once

#include "hard_case_test.h"
#include "technique_tiers.h"
#include "view_bench.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace agaa::test {

template <class Host> class FramePlaceCases : public HardCaseTest<Host> {
protected:
    static constexpr uint32_t wide = 48, high = 32;            // the view and its output
    static constexpr uint32_t width = 29, height = 19;         // the smaller frame: no multiple of a tile
    static constexpr uint32_t outputX = 11, outputY = 6;       // its place
    static constexpr float under[3] = {0.25f, 0.5f, 0.75f};    // the background of whole frames
    static constexpr float placed[3] = {0.75f, 0.25f, 0.125f}; // and of the smaller ones

    static ViewSettings settingsOf(const TechniqueTier& tier, uint32_t w, uint32_t h) {
        ViewSettings settings;
        settings.width = w;
        settings.height = h;
        apply(tier, settings);
        settings.facts.shadowMapCount = 0;
        settings.facts.maxLights = 2;
        return settings;
    }
    static Shot shotOf(std::function<void(AgaaFrame&)> change) {
        AgaaLight lamp = AGAA_LIGHT_INIT;
        lamp.type = AGAA_LIGHT_POINT;
        std::ranges::copy(std::array{1.0f, 1.0f, -4.0f}, lamp.position);
        std::ranges::fill(lamp.color, 20.0f);
        lamp.range = 5;
        return {.triangles = randomTriangles({.triangles = 200}, 7), .lights = {sun(), lamp}, .change = change};
    }
    static void place(AgaaFrame& frame, uint32_t x = outputX, uint32_t y = outputY) {
        frame.width = width;
        frame.height = height;
        frame.outputX = x;
        frame.outputY = y;
        std::ranges::copy(placed, frame.background);
    }
    // Returns the placed part of an output.
    static std::vector<float> part(const std::vector<float>& rgb) {
        std::vector<float> out;
        for (uint32_t y = 0; y < height; ++y) {
            const auto row = rgb.begin() + 3 * ((outputY + y) * wide + outputX);
            out.insert(out.end(), row, row + 3 * width);
        }
        return out;
    }
    // Returns whether both outputs are equal outside the placed part.
    static bool isKeptAround(std::vector<float> a, std::vector<float> b) {
        for (std::vector<float>* rgb : {&a, &b})
            for (uint32_t y = 0; y < height; ++y)
                std::fill_n(rgb->begin() + 3 * ((outputY + y) * wide + outputX), 3 * width, 0.0f);
        return a == b;
    }
};
TYPED_TEST_SUITE_P(FramePlaceCases);

// A frame of fewer pixels shows what a view of this size shows, bit by bit, and the next whole frame what it showed
// before.
TYPED_TEST_P(FramePlaceCases, SmallerFramesShowTheSame) {
    using Cases = FramePlaceCases<TypeParam>;
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        if (!rendersSetting<TypeParam>(setting++) || tier.isBatched || !runs(tier, this->context.get()->caps))
            continue;
        bool isPlaced = false;
        const Shot shot = Cases::shotOf([&](AgaaFrame& frame) {
            std::ranges::copy(Cases::under, frame.background);
            if (isPlaced)
                Cases::place(frame);
        });
        ViewBench<TypeParam> bench(this->context, Cases::settingsOf(tier, Cases::wide, Cases::high), shot);
        const Shown whole = bench.show(shot.triangles);
        isPlaced = true;
        const Shown placed = bench.show(shot.triangles);
        isPlaced = false;
        const Shown again = bench.show(shot.triangles);

        const Shot alone = Cases::shotOf([](AgaaFrame& frame) { std::ranges::copy(Cases::placed, frame.background); });
        ViewBench<TypeParam> small(this->context, Cases::settingsOf(tier, Cases::width, Cases::height), alone);
        const Shown expected = small.show(alone.triangles);
        EXPECT_EQ(Cases::part(placed.rgb), expected.rgb);
        EXPECT_EQ(placed.counters.shadingEvents, expected.counters.shadingEvents);
        EXPECT_EQ(placed.counters.visible, expected.counters.visible);
        EXPECT_EQ(again.rgb, whole.rgb);
        EXPECT_NE(expected.rgb, std::vector<float>(expected.rgb.size(), expected.rgb[0]));
    }
}

// Pixels around the frame keep what an earlier frame showed there. A frame without geometry shows its background, or
// with AGAA_VIEW_COMPOSITE the output below.
TYPED_TEST_P(FramePlaceCases, OutputsAreShared) {
    using Cases = FramePlaceCases<TypeParam>;
    for (const TechniqueTier& tier : {TechniqueTier{.technique = "fxaa", .n = 1},
                                      {.technique = "smaa", .n = 1},
                                      {.technique = "msaa", .n = 4},
                                      {.technique = "visibility", .n = 8},
                                      {.technique = "adaptive", .n = 8},
                                      {.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS}}) {
        SCOPED_TRACE(testing::Message() << tier);
        ViewSettings settings = Cases::settingsOf(tier, Cases::wide, Cases::high);
        settings.flags |= AGAA_VIEW_COMPOSITE;
        enum { Whole, Placed, Composited } kind = Whole;
        const Shot shot = Cases::shotOf([&](AgaaFrame& frame) {
            std::ranges::copy(Cases::under, frame.background);
            if (kind != Whole)
                Cases::place(frame);
            frame.background[3] = kind == Composited ? 0.0f : 1.0f;
        });
        ViewBench<TypeParam> bench(this->context, settings, shot);
        bench.keepsOutput = true;
        const std::vector<float> whole = bench.show(shot.triangles).rgb;
        kind = Placed;
        const std::vector<float> placed = bench.show(shot.triangles).rgb;
        EXPECT_TRUE(Cases::isKeptAround(whole, placed));
        EXPECT_NE(whole, placed);
        kind = Composited;
        const std::vector<float> composited = bench.show({}).rgb;
        EXPECT_TRUE(composited == placed || tier.n == 1) << "fxaa and smaa filter the output below";
        kind = Placed;
        const std::vector<float> empty = Cases::part(bench.show({}).rgb);
        for (size_t i = 0; i < empty.size(); ++i)
            ASSERT_EQ(empty[i], Cases::placed[i % 3]);
    }
}

// Views that remember earlier frames forget those of another size.
TYPED_TEST_P(FramePlaceCases, OtherSizesAreForgotten) {
    using Cases = FramePlaceCases<TypeParam>;
    for (const TechniqueTier& tier : {TechniqueTier{.technique = "taa", .n = 1}, {.technique = "adaptive", .n = 8}}) {
        SCOPED_TRACE(testing::Message() << tier);
        const auto settingsOf = [&](uint32_t w, uint32_t h) {
            ViewSettings settings = Cases::settingsOf(tier, w, h);
            settings.config.adaptive.countMemory = 0.9f;
            return settings;
        };
        AgaaTemporalFrame temporal = AGAA_TEMPORAL_FRAME_INIT;
        temporal.resets = 0;
        const auto remember = [&](AgaaFrame& frame) {
            std::ranges::copy(frame.projection, temporal.previousProjection);
            frame.pNext = &temporal;
        };
        bool isPlaced = false;
        const Shot shot = Cases::shotOf([&](AgaaFrame& frame) {
            remember(frame);
            std::ranges::copy(Cases::placed, frame.background);
            if (isPlaced)
                Cases::place(frame);
        });
        ViewBench<TypeParam> bench(this->context, settingsOf(Cases::wide, Cases::high), shot);
        bench.show({});
        bench.show(randomTriangles({.triangles = 100}, 8));
        isPlaced = true;
        const std::vector<float> first = Cases::part(bench.show(shot.triangles).rgb);
        const std::vector<float> second = Cases::part(bench.show(shot.triangles).rgb);
        const Shot alone = Cases::shotOf([&](AgaaFrame& frame) {
            remember(frame);
            std::ranges::copy(Cases::placed, frame.background);
        });
        ViewBench<TypeParam> small(this->context, settingsOf(Cases::width, Cases::height), alone);
        EXPECT_EQ(first, small.show(shot.triangles).rgb);
        EXPECT_EQ(second, small.show(shot.triangles).rgb);
    }
}

// Views of two eyes, recorded one after the other into one command buffer and one output.
TYPED_TEST_P(FramePlaceCases, TwoViewsShareACommandBufferAndAnOutput) {
    using Cases = FramePlaceCases<TypeParam>;
    constexpr uint32_t half = Cases::wide / 2;
    const std::vector<Triangle> triangles = randomTriangles({.triangles = 200}, 7);
    for (const TechniqueTier& tier : {TechniqueTier{.technique = "agaa", .n = 8, .tier = AGAA_TIER_POST_DEPTH_ATOMICS},
                                      {.technique = "ssaa", .n = 8}}) {
        SCOPED_TRACE(testing::Message() << tier);
        ViewSettings settings[] = {Cases::settingsOf(tier, Cases::wide, Cases::high),
                                   Cases::settingsOf(tier, half, Cases::high)};
        std::vector<float> alone[2];
        for (int eye = 0; eye < 2; ++eye) {
            settings[eye].projection = perspective(60, float(half) / float(Cases::high), 0.1f, 100);
            settings[eye].view = glm::rotate(glm::mat4(1), eye == 0 ? 0.1f : -0.1f, {0, 1, 0});
            ViewSettings own = settings[eye];
            own.width = half;
            alone[eye] = show(this->context, own, {.triangles = triangles}).rgb;
        }
        typename TypeParam::View left(this->context, settings[0]), right(this->context, settings[1]);
        left.setTriangles(triangles);
        right.setTriangles(triangles);
        const AgaaLight light = sun();
        const auto frameOf = [&](auto& view, uint32_t x) {
            AgaaFrame frame = view.frame();
            frame.lights = &light;
            frame.lightCount = 1;
            frame.width = half;
            frame.height = Cases::high;
            frame.outputX = x;
            return frame;
        };
        const AgaaFrame frames[] = {frameOf(left, 0), frameOf(right, half)};
        TypeParam::run(left, [&](typename TypeParam::Frame& native) {
            EXPECT_EQ(TypeParam::recordFrame(left.get(), &frames[0], &native), AGAA_OK);
            if constexpr (requires { native.outputLayoutIn; })
                native.outputLayoutIn = native.outputLayoutOut;
            EXPECT_EQ(TypeParam::recordFrame(right.get(), &frames[1], &native), AGAA_OK);
        });
        const std::vector<float> both = withoutAlpha(TypeParam::rgba(left));
        for (uint32_t y = 0; y < Cases::high; ++y)
            for (uint32_t i = 0; i < 3 * Cases::wide; ++i) {
                const std::vector<float>& eye = alone[i / (3 * half)];
                ASSERT_EQ(both[3 * y * Cases::wide + i], eye[3 * y * half + i % (3 * half)]) << y << ' ' << i / 3;
            }
        EXPECT_NE(alone[0], alone[1]);
    }
}

REGISTER_TYPED_TEST_SUITE_P(FramePlaceCases, SmallerFramesShowTheSame, OutputsAreShared, OtherSizesAreForgotten,
                            TwoViewsShareACommandBufferAndAnOutput);

} // namespace agaa::test
