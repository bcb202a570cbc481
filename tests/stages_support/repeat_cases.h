// Repeatability: frames of one scene, and of the same scene drawn in other orders, in every technique and tier. Each
// graphics API instantiates these.
#pragma once

#include "hard_case_test.h"
#include "technique_tiers.h"
#include "view_bench.h"

#include "core/abi/handles.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

namespace agaa::test {

// The effect of another order of the draws, outside samples where depths tie.
enum class OrderEffect {
    None,    // bitwise equal
    Merging, // other fragments merge
};
inline OrderEffect orderEffect(const TechniqueTier& tier) {
    const bool mergesInOrder = tier.tier == AGAA_TIER_FRAGMENT_INTERLOCK || tier.tier == AGAA_TIER_RASTER_ORDER;
    return mergesInOrder ? OrderEffect::Merging : OrderEffect::None;
}

// Returns whether each sample with a tie shows in its own pixel and in no other: fxaa, smaa and visibility take from
// other pixels, and sbaa and adaptive compare samples that they do not shade.
inline bool showsAllSamples(const TechniqueTier& tier) {
    for (const char* technique : {"fxaa", "smaa", "visibility", "sbaa", "adaptive"})
        if (std::strcmp(tier.technique, technique) == 0)
            return false;
    return true;
}

// A dense scene: each pixel shows parts of several triangles before a wall, a third of them masked. With ties, some
// opaque triangles have the positions of another one.
inline std::vector<Triangle> repeatScene(bool hasTies) {
    std::vector<Triangle> list =
        randomTriangles({.triangles = 100, .duplicates = hasTies ? 0.1f : 0.0f, .masked = 0.3f}, 77);
    for (uint32_t i = 0; i < list.size(); ++i) {
        list[i].seed = i + 1; // of its mask, whatever its place in the list
        for (uint32_t j = 0; j < i; ++j)
            if (std::equal(list[i].position, list[i].position + 3, list[j].position))
                list[i].isMasked = list[j].isMasked = false;
    }
    Triangle wall = list[0];
    wall.position[0] = {-100, -100, -25};
    wall.position[1] = {200, -100, -25};
    wall.position[2] = {-100, 200, -25};
    wall.material = facing(glm::vec3(0.5f));
    wall.isMasked = false;
    list.push_back(wall);
    return list;
}

// The same triangles: those that share their positions with another glow, all others are black.
inline std::vector<Triangle> glowingTies(std::vector<Triangle> list) {
    std::vector<Triangle> result = list;
    for (size_t i = 0; i < list.size(); ++i) {
        bool isTied = false;
        for (size_t j = 0; j < list.size(); ++j)
            isTied |= i != j && std::equal(list[i].position, list[i].position + 3, list[j].position);
        result[i].material.diffuse = glm::vec4(glm::vec3(isTied ? 1.0f : 0.0f), list[i].material.diffuse.w);
        result[i].material.specular = glm::vec4(0);
        result[i].material.emissive = glm::vec4(isTied ? 4.0f : 0.0f);
    }
    return result;
}

struct ImageDifference {
    size_t pixels = 0, firstPixel = 0;
    float largest = 0; // of the tone-mapped values
};
inline ImageDifference imageDifference(const std::vector<float>& a, const std::vector<float>& b,
                                       const std::vector<bool>& isLeftOut = {}) {
    ImageDifference d;
    for (size_t p = 0; p < a.size() / 3; ++p) {
        if ((!isLeftOut.empty() && isLeftOut[p]) || std::memcmp(&a[3 * p], &b[3 * p], 3 * sizeof(float)) == 0)
            continue;
        if (d.pixels++ == 0)
            d.firstPixel = p;
        for (size_t i = 3 * p; i < 3 * p + 3; ++i)
            d.largest = std::max(d.largest, std::fabs(a[i] / (1 + a[i]) - b[i] / (1 + b[i])));
    }
    return d;
}

// Frames of one view that are compared with the first one.
class RepeatedFrames {
public:
    explicit RepeatedFrames(std::vector<float> first) : first_(std::move(first)) {}
    const std::vector<float>& first() const { return first_; }
    void add(const std::vector<float>& rgb, const std::vector<bool>& isLeftOut = {}) {
        const ImageDifference d = imageDifference(rgb, first_, isLeftOut);
        ++frames_;
        largest_ = std::max(largest_, d.largest);
        mostPixels_ = std::max(mostPixels_, d.pixels);
        if (d.pixels > 0 && different_++ == 0)
            firstOne_ = frames_, firstPixel_ = d.firstPixel;
    }
    int different() const { return different_; }
    size_t mostPixels() const { return mostPixels_; }
    float largest() const { return largest_; }
    std::string text(uint32_t width) const {
        return std::to_string(different_) + " of " + std::to_string(frames_) + " frames differ, frame " +
               std::to_string(firstOne_) + " first at pixel " + std::to_string(firstPixel_ % width) + ", " +
               std::to_string(firstPixel_ / width) + "; at most " + std::to_string(mostPixels_) + " pixels, by " +
               std::to_string(largest_);
    }

private:
    std::vector<float> first_;
    int frames_ = 0, different_ = 0, firstOne_ = 0;
    size_t firstPixel_ = 0, mostPixels_ = 0;
    float largest_ = 0;
};

template <class Host> class RepeatCases : public testing::Test {
protected:
    // Software rasterisers do without the words of the interlock.
    RepeatCases() : hasInterlock(context.caps().flags & AGAA_DEVICE_FRAGMENT_INTERLOCK) {
        if (context.caps().flags & AGAA_DEVICE_SOFTWARE)
            context.get()->caps.flags |= AGAA_DEVICE_FRAGMENT_INTERLOCK;
    }
    ViewSettings settingsOf(const TechniqueTier& tier) const {
        ViewSettings settings;
        apply(tier, settings);
        const glm::uvec2 extent = tier.isBatched ? batchedExtent : glm::uvec2(24, 16);
        settings.width = extent.x;
        settings.height = extent.y;
        settings.facts.shadowMapCount = 0;
        settings.hasInterlock = hasInterlock;
        return settings;
    }
    static Shot shotOf(const TechniqueTier& tier, const std::vector<Triangle>& scene) {
        return {.triangles = scene, .change = addAmbient, .fetchFlags = tier.isMixed ? AGAA_FETCH_NOT_ALL_DRAWS : 0};
    }

    typename Host::Context context;
    bool hasInterlock;
};
TYPED_TEST_SUITE_P(RepeatCases);

constexpr int repeatedFrames = 100, drawOrders = 8;

// Hard cases 35, 51 and 67: 100 frames are bitwise equal. Another order of the draws changes nothing outside samples
// where depths tie, except in tiers that merge in the order of the draws.
TYPED_TEST_P(RepeatCases, HardCase35FramesRepeatAndOrderIsFreeOutsideTies) {
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        if (!rendersSetting<TypeParam>(setting++) || !runs(tier, this->context.get()->caps))
            continue;
        const bool hasTies = showsAllSamples(tier);
        const ViewSettings settings = this->settingsOf(tier);
        std::vector<Triangle> scene = repeatScene(hasTies);
        ViewBench<TypeParam> bench(this->context, settings, this->shotOf(tier, scene));
        bench.setTriangles(scene);
        RepeatedFrames frames(bench.rgb());
        EXPECT_EQ(nonFinite(frames.first()), 0u);
        EXPECT_GT(sumOf(frames.first()), 100);
        const AgaaCounters counters = bench.view().statistics().counters;
        EXPECT_EQ(counters.lostFragments, 0u);
        EXPECT_EQ(counters.batches > 1, tier.isBatched);
        for (int i = 1; i < (tier.isBatched ? 3 : repeatedFrames); ++i) // its view is 130 times as large
            frames.add(bench.rgb());
        EXPECT_EQ(frames.different(), 0) << frames.text(settings.width);

        if (tier.isMixed || tier.isBatched)
            continue; // the place in the list decides whether a draw is fetched; batches merge as one draw does
        const std::vector<float> glow = bench.show(glowingTies(scene)).rgb;
        std::vector<bool> isTied(glow.size() / 3);
        for (size_t p = 0; p < isTied.size(); ++p)
            isTied[p] = glow[3 * p] > 0.01f;
        const auto tied = size_t(std::ranges::count(isTied, true));
        EXPECT_EQ(tied > 0, hasTies);
        EXPECT_LT(tied, isTied.size() / 2);
        RepeatedFrames orders(frames.first());
        std::mt19937 random(9);
        for (int i = 0; i < drawOrders; ++i) {
            std::shuffle(scene.begin(), scene.end(), random);
            orders.add(bench.show(scene).rgb, isTied);
        }
        switch (orderEffect(tier)) {
        case OrderEffect::None:
            EXPECT_EQ(orders.different(), 0) << orders.text(settings.width);
            break;
        case OrderEffect::Merging:
            EXPECT_GT(orders.different(), 0) << "the order is free: state it in orderEffect()";
            EXPECT_LE(orders.largest(), 0.3f) << orders.text(settings.width);
            break;
        }
        std::printf("%s n=%u %s: %zu pixels with ties; orders change at most %zu others, by at most %.2g\n",
                    tier.technique, tier.n, agaaTierName(tier.tier), tied, orders.mostPixels(),
                    double(orders.largest()));
    }
}

REGISTER_TYPED_TEST_SUITE_P(RepeatCases, HardCase35FramesRepeatAndOrderIsFreeOutsideTies);

} // namespace agaa::test
