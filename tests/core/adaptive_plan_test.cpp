// Plans of `adaptive`: ordered grids, orders of samples, and passes that options add.
#include "plan_support.h"

#include "core/base/error.h"
#include "core/plan/sample_order.h"
#include "core/plan/sample_patterns.h"
#include "core/view/tiers.h"

#include "shaders/tables/choice_words.inc"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

using namespace agaa;
using namespace agaa::test;

namespace {

Plan adaptivePlan(uint32_t samples, const std::function<void(AgaaAdaptiveSampling&)>& change = {},
                  const AgaaDeviceCaps& caps = fourSampleDevice()) {
    return planFor({.technique = "adaptive",
                    .samples = samples,
                    .width = 64,
                    .height = 48,
                    .change =
                        [&](TechniqueConfig& config) {
                            if (change)
                                change(config.adaptive);
                        }},
                   caps);
}

std::vector<std::string> computePasses(const Plan& plan) {
    std::vector<std::string> names;
    for (const Pass& pass : plan.passes)
        if (pass.kind() == PassKind::Compute)
            names.push_back(std::filesystem::path(pass.compute().file).stem().string());
    return names;
}

TEST(Adaptive, WindowsAreOrderedGrids) {
    for (const auto& [samples, side] : {std::pair{4u, 2u}, {9u, 3u}, {16u, 4u}}) {
        const Plan plan = adaptivePlan(samples);
        EXPECT_EQ(plan.view.visibilityTier, AGAA_TIER_ORDERED_GRID);
        EXPECT_EQ(plan.view.hwSamples, 1u);
        EXPECT_EQ(plan.view.scaleX, side);
        EXPECT_EQ(plan.view.scaleY, side);
        const std::vector<SamplePosition> positions = positionsOf(plan);
        for (uint32_t i = 0; i < samples; ++i) {
            EXPECT_FLOAT_EQ(positions[i].x, (float(i % side) + 0.5f) / float(side));
            EXPECT_FLOAT_EQ(positions[i].y, (float(i / side) + 0.5f) / float(side));
        }
        const auto device = [](AgaaAdaptiveSampling& a) { a.flags |= AGAA_ADAPTIVE_DEVICE_PATTERN; };
        if (samples != 9) {
            EXPECT_NE(adaptivePlan(samples, device).view.visibilityTier, AGAA_TIER_ORDERED_GRID);
        }
    }
    AgaaDeviceCaps small = fourSampleDevice(); // 64 pixels times 4 do not fit
    small.maxImageSize = 255;
    EXPECT_EQ(adaptivePlan(16, {}, small).view.visibilityTier, AGAA_TIER_SCALED_TARGET);
    for (uint32_t samples : {1u, 2u, 8u, 32u})
        EXPECT_NE(adaptivePlan(samples, {}, idealDevice()).view.visibilityTier, AGAA_TIER_ORDERED_GRID);
    // Other techniques have grids where they are asked for.
    EXPECT_EQ(planFor({.technique = "ssaa", .samples = 16, .visibilityTier = AGAA_TIER_ORDERED_GRID}, idealDevice())
                  .view.scaleX,
              4u);
    EXPECT_EQ(planFor({.technique = "agaa", .samples = 16, .visibilityTier = AGAA_TIER_ORDERED_GRID}, idealDevice())
                  .view.scaleY,
              4u);
    EXPECT_EQ(planFor({.technique = "ssaa", .samples = 9}, idealDevice()).view.visibilityTier, AGAA_TIER_ORDERED_GRID);
    EXPECT_THROW(planFor({.technique = "ssaa", .samples = 8, .visibilityTier = AGAA_TIER_ORDERED_GRID}, idealDevice()),
                 Error);
    EXPECT_THROW(planFor({.technique = "ssaa", .samples = 9, .visibilityTier = AGAA_TIER_SCALED_TARGET}, idealDevice()),
                 Error);
    EXPECT_THROW(planFor({.technique = "agaa", .samples = 9}, idealDevice()), Error);
}

// Where the j-th sample comes in the order of Bayer 1973, which the paper prints as dither matrices; any of its
// rotations and reflections does.
bool isBayer(const std::vector<uint32_t>& order, uint32_t side) {
    const std::vector<uint32_t> two = {0, 2, 3, 1}, four = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    const std::vector<uint32_t>& matrix = side == 2 ? two : four;
    std::vector<uint32_t> rank(order.size());
    for (uint32_t j = 0; j < order.size(); ++j)
        rank[order[j]] = j;
    // The first 1, 2, 4, 8 and 16 samples: within a step, the order may differ.
    std::set<std::set<uint32_t>> own, expected;
    for (uint32_t step = 1; step <= order.size(); step *= 2) {
        std::set<uint32_t> first;
        for (uint32_t i = 0; i < order.size(); ++i)
            if (rank[i] < step)
                first.insert(i);
        own.insert(first);
    }
    for (uint32_t x = 0; x < side; ++x)
        for (uint32_t y = 0; y < side; ++y)
            for (uint32_t step = 1; step <= order.size(); step *= 2) {
                std::set<uint32_t> first; // the matrix, moved: edges of the pixel meet
                for (uint32_t i = 0; i < order.size(); ++i)
                    if (matrix[(i / side + y) % side * side + (i % side + x) % side] < step)
                        first.insert(i);
                expected.insert(first);
            }
    return std::all_of(own.begin(), own.end(), [&](const std::set<uint32_t>& s) { return expected.contains(s); });
}

// Which has the device's pattern where the host does not say otherwise.
TEST(Adaptive, AGBufferOfTheHostIsNoGrid) {
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    function.glsl =
        "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return false; }";
    for (uint32_t samples : {4u, 16u}) {
        const auto plan = [&](uint32_t tier) {
            return planFor({.technique = "adaptive", .samples = samples, .visibilityTier = tier, .chained = &function},
                           fourSampleDevice());
        };
        EXPECT_EQ(plan(AGAA_TIER_AUTO).view.visibilityTier, samples == 4 ? AGAA_TIER_NATIVE : AGAA_TIER_SCALED_TARGET);
        EXPECT_EQ(plan(AGAA_TIER_ORDERED_GRID).view.visibilityTier, AGAA_TIER_ORDERED_GRID);
    }
}

TEST(Adaptive, SamplesComeInAnOrderThatSpreads) {
    EXPECT_TRUE(isBayer(sampleOrder(positionsOf(adaptivePlan(4))), 2));
    EXPECT_TRUE(isBayer(sampleOrder(positionsOf(adaptivePlan(16))), 4));
    for (uint32_t samples : {1u, 2u, 4u, 8u, 9u, 16u, 32u}) {
        const Plan plan = adaptivePlan(samples, {}, idealDevice());
        const std::vector<SamplePosition> positions = positionsOf(plan);
        const std::vector<uint32_t> order = sampleOrder(positions);
        EXPECT_EQ(std::set<uint32_t>(order.begin(), order.end()).size(), samples);
        const auto fromCentre = [&](uint32_t i) { return std::hypot(positions[i].x - 0.5f, positions[i].y - 0.5f); };
        for (uint32_t i = 0; i < samples; ++i)
            EXPECT_LE(fromCentre(order[0]), fromCentre(i) + 1e-6f) << "the first is the nearest to the middle";
    }
    EXPECT_EQ(sampleOrder(positionsOf(adaptivePlan(9)))[0], 4u);
}

TEST(Adaptive, OptionsAddPassesOfTheirOwn) {
    using Names = std::vector<std::string>;
    const auto passes = [](const std::function<void(AgaaAdaptiveSampling&)>& change) {
        return computePasses(adaptivePlan(9, change));
    };
    EXPECT_EQ(passes({}), (Names{"shade_first", "list_further", "shade_further"}));
    EXPECT_EQ(passes([](AgaaAdaptiveSampling& a) { a.targetEvents = 2; }),
              (Names{"sample_demand", "sample_limit", "shade_first", "count_samples", "shading_demand", "shading_limit",
                     "list_further", "shade_further"}));
    EXPECT_EQ(passes([](AgaaAdaptiveSampling& a) { a.targetEvents = 2, a.flags = AGAA_ADAPTIVE_GEOMETRY; }),
              (Names{"sample_demand", "sample_limit", "shade_first", "list_further", "shade_further"}));
    EXPECT_EQ(passes([](AgaaAdaptiveSampling& a) { a.flags |= AGAA_ADAPTIVE_SORTED; }),
              (Names{"shade_first", "count_samples", "list_further", "place_counts", "place_pixels", "shade_further"}));
    for (const uint64_t flag : {AGAA_ADAPTIVE_BUCKETS, AGAA_ADAPTIVE_TILE_MAXIMUM, uint64_t(0)})
        EXPECT_EQ(passes([&](AgaaAdaptiveSampling& a) { a.flags |= flag, a.countMemory = flag ? 0 : 0.5f; }),
                  (Names{"shade_first", "count_samples", "list_further", "shade_further"}));
}

// Passes that have listed pixels alone.
TEST(Adaptive, ListsSayHowManyGroupsThereAre) {
    const Plan plan = adaptivePlan(9, [](AgaaAdaptiveSampling& a) { a.flags |= AGAA_ADAPTIVE_SORTED; });
    std::vector<std::pair<std::string, uint64_t>> lists;
    for (const Pass& pass : plan.passes)
        if (pass.kind() == PassKind::Compute && pass.compute().dispatch.kind == DispatchKind::Indirect) {
            EXPECT_EQ(pass.compute().dispatch.arguments, plan.surface("sample-choices"));
            lists.emplace_back(pass.name, pass.compute().dispatch.argumentsOffset);
        }
    using Lists = std::vector<std::pair<std::string, uint64_t>>;
    EXPECT_EQ(lists, (Lists{{"count samples", 4 * (AGAA_COMPLEX_PIXELS_AT + 1)},
                            {"place pixels", 4 * (AGAA_FURTHER_AT + 1)},
                            {"shade further samples", 4 * (AGAA_FURTHER_AT + 1)}}));
}

TEST(Adaptive, MemoryIsAGBufferFirstSamplesAndChoices) {
    const Plan ssaa = planFor({.technique = "ssaa", .samples = 9}, fourSampleDevice());
    const auto perPixel = [](const Plan& plan, uint64_t constant) {
        return double(plan.totalBytes() - constant) / (double(plan.view.width) * plan.view.height);
    };
    constexpr uint64_t sums = 4 * AGAA_SUM_WORDS;
    const double gbuffer = perPixel(ssaa, 0);
    EXPECT_EQ(perPixel(adaptivePlan(9), sums), gbuffer + 8 + 8);
    EXPECT_EQ(perPixel(adaptivePlan(9, [](AgaaAdaptiveSampling& a) { a.countMemory = 0.5f; }), sums), gbuffer + 8 + 12);
    EXPECT_EQ(perPixel(adaptivePlan(9, [](AgaaAdaptiveSampling& a) { a.flags |= AGAA_ADAPTIVE_SORTED; }), sums),
              gbuffer + 8 + 16);
    const Plan remembering = adaptivePlan(9, [](AgaaAdaptiveSampling& a) { a.countMemory = 0.5f; });
    EXPECT_TRUE(remembering.resources[remembering.surface("sample-choices")].isPersistent);
    const Plan plain = adaptivePlan(9);
    EXPECT_FALSE(plain.resources[plain.surface("sample-choices")].isPersistent);
}

} // namespace
