// What the debug views show, against the counters of the same frame. Each graphics API instantiates
// these.
#pragma once

#include "shown.h"

#include <gtest/gtest.h>

#include <cmath>

namespace agaa::test {

template <class Host>
class DebugViewCases : public testing::Test {
protected:
    Shown render(const char* technique, uint32_t tier, uint32_t view) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.generationTier = tier;
        settings.config.debugView = view;
        settings.facts.shadowMapCount = 0;
        return show(context, settings,
                    {.triangles = randomTriangles({.triangles = 150, .masked = 0.2f}, 61)});
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
    for (const char* technique : {"single", "ssaa", "simple_complex", "sbaa", "agaa"}) {
        const Shown events = this->render(technique, AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_EVENTS);
        EXPECT_EQ(this->sumOfRed(events), double(events.counters.shadingEvents)) << technique;
    }
    for (const char* technique : {"sbaa", "agaa"})
        for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
            if (technique == std::string("sbaa") && tier == AGAA_TIER_IDS)
                continue; // which is for "agaa"
            const Shown aggregates = this->render(technique, tier, AGAA_DEBUG_VIEW_AGGREGATES);
            EXPECT_EQ(this->sumOfRed(aggregates), double(aggregates.counters.aggregates))
                << technique;
            EXPECT_GT(aggregates.counters.aggregates, aggregates.counters.shadedPixels);
        }
}

// Half the space is lit, by a function that says so.
TYPED_TEST_P(DebugViewCases, LitIsTheShareOfLight) {
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return position.x > 0.0 ? "
                    "1.0 : 0.25; }";
    function.shadows = 1;
    for (const char* technique : {"ssaa", "agaa"}) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.debugView = AGAA_DEBUG_VIEW_LIT;
        settings.facts.shadowMapCount = 1;
        settings.chained = &function;
        const AgaaShadow shadow{};
        const Shown shown = show(
            this->context, settings,
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
        const Shown lit =
            this->render("agaa", tier, AGAA_DEBUG_VIEW_LIT); // without shadows everything is
        EXPECT_NEAR(this->sumOfRed(lit), double(lit.counters.shadedPixels),
                    1e-3 * this->sumOfRed(lit));
        const Shown widened = this->render("agaa", tier, AGAA_DEBUG_VIEW_WIDENED);
        EXPECT_GT(widened.counters.widenedLobes, 0u);
        EXPECT_GT(this->sumOfRed(widened), 0);
        for (float value : widened.rgb) {
            ASSERT_GE(value, 0);
            ASSERT_LE(value, 1);
        }
    }
}

// A pixel of one aggregate has its colour, one of several a mixture.
TYPED_TEST_P(DebugViewCases, ColoursTellClustersAndTiersApart) {
    const Shown clusters = this->render("agaa", AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_CLUSTERS);
    const Shown number = this->render("agaa", AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_AGGREGATES);
    size_t whole = 0, mixed = 0;
    for (size_t i = 0; i < clusters.rgb.size(); i += 3) {
        const bool isFirst =
            std::fabs(clusters.rgb[i + 2] - 0.45f) < 2e-3f && clusters.rgb[i] < 1e-3f;
        if (number.rgb[i] == 1) {
            ASSERT_TRUE(isFirst);
            ++whole;
        } else if (number.rgb[i] > 1) {
            ASSERT_FALSE(isFirst);
            ++mixed;
        }
    }
    EXPECT_GT(whole, 0u);
    EXPECT_GT(mixed, 0u);
    const Shown two = this->render("agaa", AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_TIER);
    const Shown gbuffer = this->render("agaa", AGAA_TIER_GBUFFER, AGAA_DEBUG_VIEW_TIER);
    const auto expectColour = [&](const Shown& shown, glm::vec3 colour) {
        for (size_t i = 0; i < number.rgb.size(); i += 3)
            for (size_t c = 0; c < 3; ++c) {
                const float events = number.rgb[i];
                const float bright = events == 0 ? 0.0f : events == 1 ? 0.5f : 1.0f;
                ASSERT_NEAR(shown.rgb[i + c], bright * colour[int(c)], 2e-3f);
            }
    };
    expectColour(two, {0.9f, 0.4f, 0.0f});
    size_t blue = 0; // shading normals part other pixels than geometric ones do
    for (size_t i = 0; i < gbuffer.rgb.size(); i += 3) {
        ASSERT_EQ(gbuffer.rgb[i], 0);
        blue += gbuffer.rgb[i + 2] > 0.4f;
    }
    EXPECT_EQ(blue, gbuffer.counters.shadedPixels);
}

REGISTER_TYPED_TEST_SUITE_P(DebugViewCases, NumbersAreThoseOfTheCounters, LitIsTheShareOfLight,
                            SharesLieInTheirRange, ColoursTellClustersAndTiersApart);

} // namespace agaa::test
