// What the debug views show, against the counters of the same frame. Each graphics API instantiates
// these.
#pragma once

#include "shown.h"

#include <gtest/gtest.h>

#include <cmath>

namespace agaa::test {

template <class Host> class DebugViewCases : public testing::Test {
protected:
    Shown render(const char* technique, uint32_t tier, uint32_t view, uint32_t ndf = AGAA_NDF_TOKSVIG) {
        ViewSettings settings;
        settings.config.ndf = ndf;
        settings.config.technique = technique;
        settings.config.generationTier = tier;
        settings.config.measurement.debugView = view;
        settings.facts.shadowMapCount = 0;
        return show(context, settings, {.triangles = randomTriangles({.triangles = 150, .masked = 0.2f}, 61)});
    }
    // Of the red channel.
    static double sumOfRed(const Shown& shown) {
        double sum = 0;
        for (size_t i = 0; i < shown.rgb.size(); i += 3)
            sum += double(shown.rgb[i]);
        return sum;
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(DebugViewCases);

TYPED_TEST_P(DebugViewCases, NumbersAreThoseOfTheCounters) {
    for (const char* technique : {"single", "ssaa", "visibility", "simple_complex", "sbaa", "agaa", "adaptive"}) {
        const Shown events = this->render(technique, AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_EVENTS);
        EXPECT_EQ(this->sumOfRed(events), double(events.counters.shadingEvents)) << technique;
    }
    for (const char* technique : {"sbaa", "agaa"})
        for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
            if (technique == std::string("sbaa") && tier == AGAA_TIER_IDS)
                continue; // which is for "agaa"
            const Shown aggregates = this->render(technique, tier, AGAA_DEBUG_VIEW_AGGREGATES);
            EXPECT_EQ(this->sumOfRed(aggregates), double(aggregates.counters.aggregates)) << technique;
            EXPECT_GT(aggregates.counters.aggregates, aggregates.counters.shadedPixels);
        }
}

// Half the space is lit, by a function that says so.
TYPED_TEST_P(DebugViewCases, LitIsTheShareOfLight) {
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return position.x > 0.0 ? "
                    "1.0 : 0.25; }";
    function.shadows = 1;
    struct Way {
        const char* technique;
        uint32_t tier, litShadows;
    };
    for (const auto& [technique, tier, litShadows] : {Way{"ssaa", AGAA_TIER_AUTO, 0},
                                                      {"agaa", AGAA_TIER_PER_SAMPLE, 0},
                                                      {"agaa", AGAA_TIER_GBUFFER, 0},
                                                      {"agaa", AGAA_TIER_GBUFFER, 1},
                                                      {"agaa", AGAA_TIER_IDS, 0},
                                                      {"agaa", AGAA_TIER_IDS, 1}}) {
        SCOPED_TRACE(std::string(agaaTierName(tier)) + (litShadows ? ", lit" : ""));
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.generationTier = tier;
        settings.config.aggregation.litShadows = litShadows;
        settings.config.measurement.debugView = AGAA_DEBUG_VIEW_LIT;
        settings.facts.shadowMapCount = 1;
        settings.chained = &function;
        const AgaaShadow shadow{};
        const Shown shown =
            show(this->context, settings,
                 {.triangles = randomTriangles({.triangles = 150}, 61), .change = [&](AgaaFrame& frame) {
                      frame.shadows = &shadow;
                      frame.shadowCount = 1;
                  }});
        size_t lit = 0, dim = 0;
        const size_t middle = settings.width / 2;
        for (size_t i = 0; i < shown.rgb.size(); i += 3) {
            const size_t x = i / 3 % settings.width;
            const float value = shown.rgb[i];
            if (value == 0 || x == middle || x + 1 == middle)
                continue; // no geometry; or the plane between
            ASSERT_NEAR(value, x > middle ? 1.0f : 0.25f, 1e-3f) << technique << ' ' << x;
            ++(x > middle ? lit : dim);
        }
        EXPECT_GT(lit, 100u);
        EXPECT_GT(dim, 100u);
    }
}

TYPED_TEST_P(DebugViewCases, SharesLieInTheirRange) {
    for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
        const Shown lit = this->render("agaa", tier, AGAA_DEBUG_VIEW_LIT); // without shadows everything is
        EXPECT_NEAR(this->sumOfRed(lit), double(lit.counters.shadedPixels), 1e-3 * this->sumOfRed(lit));
        const Shown widened = this->render("agaa", tier, AGAA_DEBUG_VIEW_WIDENED);
        EXPECT_GT(widened.counters.widenedLobes, 0u);
        EXPECT_GT(this->sumOfRed(widened), 0);
        EXPECT_LE(this->sumOfRed(widened), double(widened.counters.widenedLobes));
        for (float value : widened.rgb) {
            ASSERT_GE(value, 0);
            ASSERT_LE(value, 1);
        }
        const Shown narrow = this->render("agaa", tier, AGAA_DEBUG_VIEW_WIDENED, AGAA_NDF_NONE);
        EXPECT_EQ(narrow.counters.widenedLobes, 0u);
        EXPECT_EQ(this->sumOfRed(narrow), 0);
    }
}

// A pixel of one aggregate has its colour, one of several a mixture; the tier's is brighter where there are several.
TYPED_TEST_P(DebugViewCases, ColoursTellClustersAndTiersApart) {
    for (const auto& [tier, colour] : {std::pair{AGAA_TIER_AUTO, glm::vec3(0.9f, 0.4f, 0.0f)},
                                       {AGAA_TIER_GBUFFER, glm::vec3(0.0f, 0.17f, 0.9f)},
                                       {AGAA_TIER_IDS, glm::vec3(0.0f, 0.6f, 0.2f)}}) {
        SCOPED_TRACE(agaaTierName(tier));
        const Shown clusters = this->render("agaa", tier, AGAA_DEBUG_VIEW_CLUSTERS);
        const Shown number = this->render("agaa", tier, AGAA_DEBUG_VIEW_AGGREGATES);
        const Shown tiers = this->render("agaa", tier, AGAA_DEBUG_VIEW_TIER);
        size_t whole = 0, mixed = 0;
        for (size_t i = 0; i < clusters.rgb.size(); i += 3) {
            const float aggregates = number.rgb[i];
            const bool isFirst = std::fabs(clusters.rgb[i + 2] - 0.45f) < 2e-3f && clusters.rgb[i] < 1e-3f;
            if (aggregates > 0) {
                ASSERT_EQ(isFirst, aggregates == 1);
            }
            whole += aggregates == 1;
            mixed += aggregates > 1;
            const float bright = aggregates == 0 ? 0.0f : aggregates == 1 ? 0.5f : 1.0f;
            for (size_t c = 0; c < 3; ++c)
                ASSERT_NEAR(tiers.rgb[i + c], bright * colour[int(c)], 2e-3f);
        }
        EXPECT_GT(whole, 0u);
        EXPECT_GT(mixed, 0u);
    }
}

// By id, pixels with samples that came from a G-buffer have that tier's colour.
TYPED_TEST_P(DebugViewCases, UnfetchedSamplesShowTheirTier) {
    ViewSettings settings;
    settings.config.generationTier = AGAA_TIER_IDS;
    settings.config.measurement.debugView = AGAA_DEBUG_VIEW_TIER;
    settings.facts.shadowMapCount = 0;
    settings.shader = ViewSettings::Shader::ThirdUnfetched;
    const Shown shown =
        show(this->context, settings,
             {.triangles = randomTriangles({.triangles = 150}, 61), .fetchFlags = AGAA_FETCH_NOT_ALL_DRAWS});
    size_t fetched = 0, drawn = 0;
    for (size_t i = 0; i < shown.rgb.size(); i += 3) {
        fetched += shown.rgb[i + 1] > shown.rgb[i + 2];
        drawn += shown.rgb[i + 2] > shown.rgb[i + 1];
    }
    EXPECT_EQ(fetched + drawn, shown.counters.shadedPixels);
    EXPECT_GT(fetched, shown.counters.shadedPixels / 3);
    EXPECT_GT(drawn, shown.counters.shadedPixels / 4);
}

REGISTER_TYPED_TEST_SUITE_P(DebugViewCases, NumbersAreThoseOfTheCounters, LitIsTheShareOfLight, SharesLieInTheirRange,
                            ColoursTellClustersAndTiersApart, UnfetchedSamplesShowTheirTier);

} // namespace agaa::test
