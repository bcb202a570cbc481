// Material classes (AGAA_FILTER_CLASS): two materials with opposite shading share pixels of one plane. Each graphics
// API instantiates these.
#pragma once

#include "hard_case_test.h"
#include "setting_share.h"
#include "shading_function_cases.h"
#include "technique_tiers.h"
#include "view_bench.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace agaa::test {

// Diffuse albedo, normals, and the class of a material.
inline AgaaLayout layoutWithClass(uint32_t filter = AGAA_FILTER_CLASS) {
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    agaaGetBuiltinLayout("precise", &layout);
    AgaaLayoutAttribute* const end = layout.attributes + layout.attributeCount;
    const auto isOther = [](const AgaaLayoutAttribute& a) {
        return a.semantic != AGAA_SEMANTIC_DIFFUSE && a.semantic != AGAA_SEMANTIC_NORMAL;
    };
    layout.attributeCount = uint32_t(std::remove_if(layout.attributes, end, isOther) - layout.attributes);
    AgaaLayoutAttribute kind = AGAA_LAYOUT_ATTRIBUTE_INIT;
    kind.semantic = AGAA_SEMANTIC_CUSTOM;
    kind.channels = 1;
    kind.sampleBits = 8;
    kind.aggregateBits = 8;
    kind.filter = filter;
    kind.range = 255;
    kind.name = "kind";
    layout.attributes[layout.attributeCount++] = kind;
    return layout;
}

template <class Host> class MaterialClassCases : public HardCaseTest<Host> {
protected:
    static inline const AgaaLayout layout = layoutWithClass();
    // A class is shaded as red, green or blue; any other number as white.
    static inline const AgaaShadingFunction function =
        shadingFunction("vec3 agaaShade(AgaaSurface surface) {\n"
                        "    return surface.kind == 3.0 ? vec3(1.0, 0.0, 0.0)\n"
                        "         : surface.kind == 200.0 ? vec3(0.0, 1.0, 0.0)\n"
                        "         : surface.kind == 255.0 ? vec3(0.0, 0.0, 1.0) : vec3(1.0);\n"
                        "}\n",
                        AGAA_SHADING_EVENT);

    static ViewSettings settingsOf(const TechniqueTier& tier, uint32_t aggregates, bool isReversed = false) {
        ViewSettings settings = pixelView({tier.technique, tier.n});
        if (isReversed)
            reverseDepth(settings);
        apply(tier, settings);
        settings.config.layout = &layout;
        settings.config.aggregates = aggregates;
        settings.config.flags |= AGAA_CONFIG_COUNTERS;
        settings.facts.flags = 0;
        settings.facts.shadowMapCount = 0;
        settings.surface = "s.kind = s.diffuse.x > 0.9 ? 200.0 : s.diffuse.x < 0.2 ? 255.0 : 3.0;";
        settings.chained = &function;
        return settings;
    }
    // Bands of the classes 3, 200 and 255 in one plane, whose edges lie in the columns 8 and 12 of pixels, and a strip
    // of the third within column 4.
    static Shot shot(bool hasThird) {
        Shot shot;
        const auto add = [&](float from, float to, float red) {
            for (const Triangle& t : rectangle(from, 0, to, 16, 5, facing({red, 0.5f, 0.5f})))
                shot.triangles.push_back(t);
        };
        add(0, 4.55f, 0.5f);
        add(4.55f, 4.65f, 0.5f);
        add(4.65f, 8.4f, hasThird ? 1.0f : 0.5f);
        if (hasThird)
            shot.triangles[2].material = shot.triangles[3].material = facing({0.1f, 0.5f, 0.5f});
        add(8.4f, 32, hasThird ? 0.5f : 1.0f);
        shot.lights = {};
        shot.material = "m.kind = m.diffuse.x > 0.9 ? 200.0 : m.diffuse.x < 0.2 ? 255.0 : 3.0;";
        return shot;
    }
    // All tiers, and the targets of 32 samples, of which several texels make a pixel.
    static std::vector<TechniqueTier> tiers() {
        std::vector<TechniqueTier> tiers = techniqueTiers();
        for (const uint32_t tier : {AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_GBUFFER, AGAA_TIER_IDS})
            tiers.push_back({.technique = "agaa", .n = 32, .tier = tier});
        return tiers;
    }
    // Returns whether the technique groups samples by class.
    static bool keepsClassesApart(const TechniqueTier& tier) { return tier.technique == std::string("agaa"); }
};
TYPED_TEST_SUITE_P(MaterialClassCases);

// The share of a class in a pixel is that of its samples, and no event has a class between two.
TYPED_TEST_P(MaterialClassCases, OppositeShadingInOnePixel) {
    using Cases = MaterialClassCases<TypeParam>;
    for (size_t setting = 0; const TechniqueTier& tier : Cases::tiers()) {
        if (!rendersSetting<TypeParam>(setting++) || tier.isBatched || tier.isMixed || tier.layout ||
            !runs(tier, this->context.get()->caps))
            continue;
        SCOPED_TRACE(testing::Message() << tier);
        const Shot shot = Cases::shot(false);
        const Shown shown = show(this->context, Cases::settingsOf(tier, 2, setting % 4 > 1), shot);
        double mixed = 0;
        for (size_t i = 0; i < shown.rgb.size() / 3; ++i) {
            const float red = shown.rgb[3 * i], green = shown.rgb[3 * i + 1], blue = shown.rgb[3 * i + 2];
            const bool isEdge = i % 32 == 8, isFiltered = tier.n == 1 && i % 32 >= 6 && i % 32 <= 10;
            if (isFiltered)
                continue;
            ASSERT_EQ(blue, 0) << "pixel " << i;
            ASSERT_NEAR(red + green, 1, 2e-6f) << "pixel " << i;
            if (isEdge) {
                mixed = std::max(mixed, double(std::min(red, green)));
            } else {
                ASSERT_NEAR(red, i % 32 < 8 ? 1 : 0, 1e-6f) << "pixel " << i;
            }
        }
        if (!Cases::keepsClassesApart(tier))
            continue;
        // The edge lies at 0.4 of the pixel.
        EXPECT_NEAR(mixed, 0.4, 1.5 / std::min(tier.n, 16u));
        EXPECT_EQ(shown.counters.joinedClasses, 0u);
    }
}

// Where classes exceed the aggregates, the smallest is counted and takes the class of another.
TYPED_TEST_P(MaterialClassCases, TheSmallestOfTooManyJoins) {
    using Cases = MaterialClassCases<TypeParam>;
    for (size_t setting = 0; const TechniqueTier& tier : Cases::tiers()) {
        if (!rendersSetting<TypeParam>(setting++) || !Cases::keepsClassesApart(tier) || tier.n < 8 || tier.isBatched ||
            tier.isMixed || tier.layout || !runs(tier, this->context.get()->caps))
            continue;
        SCOPED_TRACE(testing::Message() << tier);
        const Shot shot = Cases::shot(true);
        for (const uint32_t aggregates : {2u, 3u}) {
            const Shown shown = show(this->context, Cases::settingsOf(tier, aggregates), shot);
            float blue = 0, least = 1;
            for (size_t i = 0; i < shown.rgb.size() / 3; ++i) {
                blue = std::max(blue, shown.rgb[3 * i + 2]);
                ASSERT_NEAR(shown.rgb[3 * i] + shown.rgb[3 * i + 1] + shown.rgb[3 * i + 2], 1, 2e-6f) << "pixel " << i;
                if (i % 32 == 4)
                    least = std::min({least, shown.rgb[3 * i], shown.rgb[3 * i + 1]});
            }
            // With two geometry passes the class of the largest fragment wins.
            const bool isTwoPass = tier.tier == AGAA_TIER_PER_SAMPLE || tier.tier == AGAA_TIER_POST_DEPTH_ATOMICS;
            if (!isTwoPass || aggregates == 3) {
                EXPECT_GT(least, 0.1f); // both large classes show
                EXPECT_EQ(blue > 0, aggregates == 3) << aggregates << " aggregates";
            }
            EXPECT_EQ(shown.counters.joinedClasses > 0, aggregates == 2) << aggregates << " aggregates";
        }
    }
}

// One aggregate has one of the classes. Fetched materials may have a class for each texel of the target.
TYPED_TEST_P(MaterialClassCases, ClassesOfOnePrimitiveAndOneAggregate) {
    using Cases = MaterialClassCases<TypeParam>;
    Shot shot = Cases::shot(false);
    shot.triangles = rectangle(0, 0, 32, 16, 5, facing({0.5f, 0.5f, 0.5f}));
    shot.material = "vec2 at = fract(vec2(16.0, 8.0) * (1.0 + vec2(dot(p.at, vec3(p.a.x, p.b.x, p.c.x)), "
                    "dot(p.at, vec3(p.a.y, p.b.y, p.c.y)))));\n"
                    "m.kind = at.x > 0.6 || at.y > 0.6 ? 200.0 : 3.0;";
    for (const TechniqueTier& tier :
         {TechniqueTier{.technique = "agaa", .n = 8, .tier = AGAA_TIER_IDS, .flags = AGAA_CONFIG_FINE_MATERIALS},
          TechniqueTier{.technique = "agaa",
          .n = 8,
          .tier = AGAA_TIER_IDS,
          .flags = AGAA_CONFIG_FINE_MATERIALS | AGAA_CONFIG_BUFFERED}})
        for (const uint32_t aggregates : {1u, 2u}) {
            SCOPED_TRACE(testing::Message() << tier << " c=" << aggregates);
            const Shown shown = show(this->context, Cases::settingsOf(tier, aggregates), shot);
            float mixed = 0;
            for (size_t i = 0; i < shown.rgb.size() / 3; ++i) {
                ASSERT_NEAR(shown.rgb[3 * i] + shown.rgb[3 * i + 1], 1, 2e-6f) << "pixel " << i;
                mixed = std::max(mixed, std::min(shown.rgb[3 * i], shown.rgb[3 * i + 1]));
            }
            EXPECT_EQ(mixed > 0, aggregates == 2);
        }
}

REGISTER_TYPED_TEST_SUITE_P(MaterialClassCases, OppositeShadingInOnePixel, TheSmallestOfTooManyJoins,
                            ClassesOfOnePrimitiveAndOneAggregate);

} // namespace agaa::test
