// Passes that group samples with one lane per pixel and per sample, and passes that merge fragments in arrays and in
// shared memory: images and counters are equal bit for bit. Each graphics API instantiates these.
#pragma once

#include "fragments_cases.h"
#include "material_class_cases.h"
#include "shown.h"

#include "core/abi/handles.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

namespace agaa::test {

struct LaneRow {
    const char* technique;
    uint32_t tier, n, c;
    uint64_t flags = 0;      // AGAA_CONFIG_…
    const char* preset = ""; // it sets c
    bool isMixed = false;    // each third triangle is not fetched
    uint32_t seeds = AGAA_SEEDS_MAXIMIN;
    uint32_t merge = AGAA_MERGE_VISIBLE; // of dcaa
    uint32_t ndf = AGAA_NDF_TOKSVIG;     // of dcaa
    bool hasTwoLit = false;              // a second lit shadow, which frames lack
    bool isExact = false;                // AGAA_COVERAGE_EXACT
    bool hasManyFragments = false;       // manyFragmentsInTile() with c above 2, otherwise manyFragments()
    uint64_t adaptive = 0;               // AGAA_ADAPTIVE_…
    float targetEvents = 0;
    bool hasClasses = false;       // five of them, with two in most pixels
    bool hasShadow = *preset != 0; // of the first light

    bool isMerging() const { return std::strcmp(technique, "dcaa") == 0 && !isExact; }
    // Passes over lists have no variant with subgroup operations.
    bool isOfLists() const { return n >= 32 && (isExact || tier == AGAA_TIER_FRAGMENTS); }
};

inline std::ostream& operator<<(std::ostream& out, const LaneRow& row) {
    return out << row.technique << ' ' << agaaTierName(row.tier) << " n=" << row.n << " c=" << row.c << ' '
               << row.preset << " flags=" << row.flags << (row.isMixed ? " some unfetched" : "")
               << " seeds=" << row.seeds << " merge=" << row.merge << " ndf=" << row.ndf
               << (row.isExact ? " exact" : "") << (row.hasManyFragments ? " many fragments" : "")
               << (row.hasClasses ? " classes" : "") << " adaptive=" << row.adaptive << " target=" << row.targetEvents
               << (row.hasShadow ? " shadow" : "");
}

constexpr uint64_t adaptiveBoth = AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_SHADING;

inline LaneRow adaptiveRow(uint32_t tier, uint32_t n, uint64_t flags, float targetEvents = 0) {
    return {.technique = "adaptive", .tier = tier, .n = n, .c = 1, .adaptive = flags, .targetEvents = targetEvents};
}

template <class Host> class LaneCases : public testing::Test {
protected:
    Shown render(const LaneRow& row, AgaaLanes lanes) {
        ViewSettings settings;
        settings.width = 24;
        settings.height = 20; // the last tiles are not whole
        settings.config.samples = row.n;
        settings.config.aggregates = row.c;
        if (*row.preset) {
            EXPECT_EQ(settings.config.applyPreset(row.preset), AGAA_OK);
        }
        settings.config.technique = row.technique;
        settings.config.generationTier = row.tier;
        settings.config.flags |= row.flags;
        settings.config.measurement.seeds = row.seeds;
        settings.config.measurement.lanes = lanes;
        settings.config.coverage.merge = row.merge;
        if (row.isMerging())
            settings.config.ndf = row.ndf;
        settings.config.coverage.flags |= row.isExact ? AGAA_COVERAGE_EXACT : 0;
        settings.config.adaptive.flags = row.adaptive;
        settings.config.adaptive.targetEvents = row.targetEvents;
        const bool hasShadow = row.hasShadow;
        settings.facts.shadowMapCount = hasShadow + row.hasTwoLit;
        if (row.hasTwoLit)
            settings.config.aggregation.litShadows = 3;
        AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
        function.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return fract(3.0 * position.x); }";
        function.shadows = row.hasTwoLit ? 3 : 1;
        if (hasShadow)
            settings.chained = &function;
        if (row.isMixed)
            settings.shader = ViewSettings::Shader::ThirdUnfetched;
        const AgaaLayout layout = layoutWithClass();
        if (row.hasClasses) {
            settings.config.layout = &layout;
            settings.surface = "s.kind = floor(fract(7.0 * s.diffuse.x) * 5.0);";
        }
        const AgaaShadow shadow{};
        Shot shot{.triangles = randomTriangles({.triangles = 150, .duplicates = 0.1f, .masked = 0.2f}, 61),
                  .change =
                      [&](AgaaFrame& frame) {
                          frame.shadows = &shadow;
                          frame.shadowCount = hasShadow;
                      },
                  .fetchFlags = row.isMixed ? AGAA_FETCH_NOT_ALL_DRAWS : 0};
        if (row.hasClasses)
            shot.material = "m.kind = floor(fract(7.0 * m.diffuse.x) * 5.0);";
        for (size_t i = 0; i < shot.triangles.size(); i += 2)
            shot.triangles[i].material.normal.w = 2e-3f; // glossy, so that normals are weighed
        shot.lights[0].shadowMap = hasShadow ? 0 : AGAA_NO_SHADOW;
        const AgaaDeviceCaps caps = context.caps();
        shot.triangles = settleTies(shot.triangles, caps);
        if (row.hasManyFragments) {
            settings.width = 48;
            settings.height = 32;
            settings.projection = pixelOrthographic(48, 32, 10);
            shot.triangles = row.c > 2 ? manyFragmentsInTile() : manyFragments();
        }
        return show(context, settings, shot);
    }

    // Compares the variants of a row, which must merge in full pixels if it is one of dcaa. Returns their number.
    uint32_t compareLanes(const LaneRow& row) {
        const Shown pixel = render(row, AGAA_LANES_PIXEL);
        const bool isAdaptive = row.adaptive != 0; // it has no aggregates
        EXPECT_GT(isAdaptive ? pixel.counters.shadingEvents : pixel.counters.aggregates,
                  pixel.counters.shadedPixels * (isAdaptive || row.c > 1))
            << row;
        if (row.hasClasses && row.c == 2 && !row.hasManyFragments) {
            EXPECT_GT(pixel.counters.joinedClasses, 0u) << row;
        }
        if (row.isMerging()) {
            EXPECT_GT(pixel.counters.mergedSecond + pixel.counters.discarded, 0u) << row;
        }
        uint32_t variants = 1;
        for (const AgaaLanes lanes : {AGAA_LANES_SAMPLE_SHARED, AGAA_LANES_SAMPLE_SUBGROUP}) {
            if (lanes == AGAA_LANES_SAMPLE_SUBGROUP &&
                (row.isOfLists() || context.caps().subgroupSize < std::bit_ceil(row.n)))
                continue;
            ++variants;
            expectSameShown(pixel, render(row, lanes), row, lanes);
        }
        return variants;
    }

    // A GPU's compiler may contract the arithmetic of one variant and not of another: on an NVIDIA H100, 2 pixels of
    // one row differ, by less than 2e-5.
    void expectSameShown(const Shown& one, const Shown& other, const LaneRow& row, AgaaLanes lanes) {
        SCOPED_TRACE(testing::Message() << row << " with lanes " << lanes);
        expectSameImage(other.rgb, one.rgb, context.caps());
        EXPECT_EQ(std::memcmp(&one.counters, &other.counters, sizeof one.counters), 0)
            << "counters of " << row << " with lanes " << lanes;
    }

    // Each c has the tier ids and one of three others in turn.
    void compareAllSettings(uint32_t n) {
        for (uint32_t c = 1; c <= std::min(n, 4u); ++c) {
            const uint32_t seeds = c % 2 ? AGAA_SEEDS_MAXIMIN : AGAA_SEEDS_SUM_OF_SQUARES;
            compareLanes({"agaa", AGAA_TIER_IDS, n, c, c == 3 ? AGAA_CONFIG_BUFFERED : 0, "", c == 2, seeds});
            if ((n + c) % 3 == 0)
                compareLanes({"agaa", AGAA_TIER_POST_DEPTH_ATOMICS, n, c, 0, "", false, seeds});
            else if ((n + c) % 3 == 1)
                compareLanes({"agaa", AGAA_TIER_GBUFFER, n, c, c % 2 ? 0 : AGAA_CONFIG_BUFFERED, "", false, seeds});
            else
                compareLanes({"sbaa", c % 2 ? AGAA_TIER_GBUFFER : AGAA_TIER_POST_DEPTH_ATOMICS, n, c});
        }
        compareLanes({"agaa", AGAA_TIER_GBUFFER, n, 4, AGAA_CONFIG_SPLIT_SURFACES, "balanced"});
        if (n >= 8)
            compareLanes({"agaa", AGAA_TIER_IDS, n, 4, 0, "balanced", true});
    }

    // Each row has other numbers of samples and surfaces, another rule and another tier.
    void compareMerging(uint32_t n, uint32_t surfaces, uint32_t merge) {
        const bool isEven = surfaces % 2 == 0;
        LaneRow row{"dcaa", isEven ? AGAA_TIER_FRAGMENT_LISTS : AGAA_TIER_MATERIAL_LISTS, n, surfaces};
        row.merge = merge;
        row.ndf = surfaces % 3 == 0 ? AGAA_NDF_LEAN : AGAA_NDF_TOKSVIG;
        compareLanes(row);
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(LaneCases);

TYPED_TEST_P(LaneCases, ShowTheSame) {
    uint32_t variants = 0;
    for (const LaneRow& row :
         {LaneRow{"agaa", AGAA_TIER_POST_DEPTH_ATOMICS, 8, 4, 0, "", false, AGAA_SEEDS_SUM_OF_SQUARES},
          LaneRow{"agaa", AGAA_TIER_GBUFFER, 4, 3}, LaneRow{"agaa", AGAA_TIER_IDS, 8, 4, 0, "accurate"},
          LaneRow{"sbaa", AGAA_TIER_GBUFFER, 8, 3},
          LaneRow{.technique = "agaa", .tier = AGAA_TIER_FRAGMENTS, .n = 64, .c = 2, .hasManyFragments = true},
          LaneRow{.technique = "agaa", .tier = AGAA_TIER_GBUFFER, .n = 8, .c = 2, .hasClasses = true},
          LaneRow{.technique = "agaa",
          .tier = AGAA_TIER_IDS,
          .n = 8,
          .c = 3,
          .seeds = AGAA_SEEDS_SUM_OF_SQUARES,
          .hasClasses = true},
          LaneRow{.technique = "agaa",
          .tier = AGAA_TIER_FRAGMENTS,
          .n = 64,
          .c = 2,
          .hasManyFragments = true,
          .hasClasses = true},
          LaneRow{.technique = "dcaa", .tier = AGAA_TIER_MATERIAL_LISTS, .n = 64, .c = 1, .isExact = true},
          adaptiveRow(AGAA_TIER_IDS, 8, adaptiveBoth, 3),
          adaptiveRow(AGAA_TIER_GBUFFER, 4, adaptiveBoth | AGAA_ADAPTIVE_BUCKETS)})
        variants += this->compareLanes(row);
    std::printf("%u variants, subgroups of %u lanes\n", variants, this->context.caps().subgroupSize);
    EXPECT_GE(variants, 22u);
}

// Each number of samples and of aggregates, each tier and each flag occurs here or in ShowTheSame.
// ShowTheSameWithAllSettings compares their product.
TYPED_TEST_P(LaneCases, ShowTheSameInACoveringSet) {
    for (const LaneRow& row :
         {LaneRow{"agaa", AGAA_TIER_IDS, 2, 1}, LaneRow{"agaa", AGAA_TIER_GBUFFER, 2, 2, 0, "", true},
          LaneRow{"agaa", AGAA_TIER_GBUFFER, 4, 2, AGAA_CONFIG_BUFFERED},
          LaneRow{"sbaa", AGAA_TIER_POST_DEPTH_ATOMICS, 4, 1},
          LaneRow{"agaa", AGAA_TIER_IDS, 8, 4, 0, "balanced", true},
          LaneRow{"agaa", AGAA_TIER_IDS, 16, 3, AGAA_CONFIG_BUFFERED},
          LaneRow{"agaa", AGAA_TIER_GBUFFER, 16, 4, AGAA_CONFIG_SPLIT_SURFACES, "balanced"},
          LaneRow{"sbaa", AGAA_TIER_GBUFFER, 32, 3}})
        this->compareLanes(row);
    LaneRow shadowed = adaptiveRow(AGAA_TIER_GBUFFER, 8, adaptiveBoth, 2.5f);
    shadowed.hasShadow = true;
    this->compareLanes(shadowed);
}

// OpenGL has the shaders of Vulkan: it compares one n.
TYPED_TEST_P(LaneCases, ShowTheSameWithAllSettings) {
    this->compareAllSettings(8);
    if (!TypeParam::runsAll)
        return;
    for (const uint32_t n : {2u, 4u, 16u})
        this->compareAllSettings(n);
    // With 32 lanes per pixel and several aggregates, software devices take up to a minute for each row.
    this->compareLanes({"agaa", AGAA_TIER_POST_DEPTH_ATOMICS, 32, 4});
    this->compareLanes({"sbaa", AGAA_TIER_GBUFFER, 32, 3});
}

// OpenGL has the shaders of Vulkan: it compares one row.
TYPED_TEST_P(LaneCases, MergeTheSame) {
    this->compareMerging(64, 4, AGAA_MERGE_VISIBLE);
    if (!TypeParam::runsAll)
        return;
    this->compareMerging(32, 1, AGAA_MERGE_VISIBLE);
    this->compareMerging(128, 3, AGAA_MERGE_PAPER);
    this->compareMerging(64, 5, AGAA_MERGE_NONE);
}

// Pixels of one primitive with several materials add each of them to the means when it is fetched. With two lit shadows
// they keep the materials.
TYPED_TEST_P(LaneCases, MeansOfKeptMaterialsAreTheSame) {
    LaneRow row{"agaa", AGAA_TIER_IDS, 16, 4, 0, "accurate"};
    const Shown added = this->render(row, AGAA_LANES_PIXEL);
    EXPECT_GT(added.counters.shadowTaps, added.counters.shadingEvents);
    row.hasTwoLit = true;
    this->expectSameShown(added, this->render(row, AGAA_LANES_PIXEL), row, AGAA_LANES_PIXEL);
}

TYPED_TEST_P(LaneCases, EverySettingOfFragments) {
    for (const uint32_t n : {32u, 64u, 128u}) {
        for (uint32_t c = 1; c <= 4; ++c) {
            this->compareLanes({"agaa", AGAA_TIER_FRAGMENTS, n, c, 0, "", false,
                                c % 2 ? AGAA_SEEDS_MAXIMIN : AGAA_SEEDS_SUM_OF_SQUARES});
            if (n > 32 && c > 1)
                this->compareLanes({.technique = "agaa",
                                    .tier = AGAA_TIER_FRAGMENTS,
                                    .n = n,
                                    .c = c,
                                    .preset = c == 4 ? "balanced" : "",
                                    .hasManyFragments = true});
        }
        this->compareLanes({"agaa", AGAA_TIER_FRAGMENTS, n, 4, AGAA_CONFIG_SPLIT_SURFACES, "accurate"});
        for (const uint32_t tier : {AGAA_TIER_FRAGMENT_LISTS, AGAA_TIER_MATERIAL_LISTS})
            this->compareLanes({.technique = "dcaa", .tier = tier, .n = n, .c = 1, .isExact = true});
    }
}

TYPED_TEST_P(LaneCases, EverySettingOfAdaptive) {
    const auto compare = [&](uint32_t tier, uint32_t n, uint64_t flags, float targetEvents = 0) {
        this->compareLanes(adaptiveRow(tier, n, flags, targetEvents));
    };
    for (const uint32_t tier : {AGAA_TIER_IDS, AGAA_TIER_GBUFFER}) {
        for (const uint32_t n : {2u, 4u, 8u, 9u, 16u, 32u})
            compare(tier, n, adaptiveBoth, n > 4 ? 2.5f : 0);
        compare(tier, 16, AGAA_ADAPTIVE_GEOMETRY);
        compare(tier, 8, AGAA_ADAPTIVE_SHADING);
        compare(tier, 8, AGAA_ADAPTIVE_GEOMETRY | AGAA_ADAPTIVE_PRINTED_METRIC);
        compare(tier, 8, adaptiveBoth | AGAA_ADAPTIVE_IN_ORDER | AGAA_ADAPTIVE_TILE_MAXIMUM);
        compare(tier, 32, adaptiveBoth | AGAA_ADAPTIVE_EQUAL_WEIGHTS | AGAA_ADAPTIVE_LOOP | AGAA_ADAPTIVE_SORTED);
    }
}

REGISTER_TYPED_TEST_SUITE_P(LaneCases, ShowTheSame, ShowTheSameInACoveringSet, ShowTheSameWithAllSettings,
                            EverySettingOfFragments, EverySettingOfAdaptive, MergeTheSame,
                            MeansOfKeptMaterialsAreTheSame);

} // namespace agaa::test
