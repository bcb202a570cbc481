// What the debug views show, against the counters of the same frame.
#include "stage_host.h"

#include <gtest/gtest.h>

#include <cmath>

namespace agaa::test {
namespace {

struct Shown {
    harness::Image image;
    AgaaCounters counters{};
    double sum = 0; // of the red channel
};

Shown show(StageContext& context, const char* technique, uint32_t tier, uint32_t view) {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.config.generationTier = tier;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    settings.config.debugView = view;
    settings.facts.shadowMapCount = 0;
    StageView host(context, settings);
    host.setTriangles(randomTriangles({.triangles = 150, .masked = 0.2f}, 61));
    const AgaaLight light = sun();
    AgaaFrame frame = host.frame();
    frame.lights = &light;
    frame.lightCount = 1;
    host.render(frame);
    Shown shown{host.image(), host.statistics().counters};
    for (size_t i = 0; i < shown.image.rgb.size(); i += 3)
        shown.sum += double(shown.image.rgb[i]);
    return shown;
}

TEST(DebugView, NumbersAreThoseOfTheCounters) {
    StageContext context;
    for (const char* technique : {"single", "ssaa", "simple_complex", "sbaa", "agaa"}) {
        const Shown events = show(context, technique, AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_EVENTS);
        EXPECT_EQ(events.sum, double(events.counters.shadingEvents)) << technique;
    }
    for (const char* technique : {"sbaa", "agaa"})
        for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER}) {
            const Shown aggregates = show(context, technique, tier, AGAA_DEBUG_VIEW_AGGREGATES);
            EXPECT_EQ(aggregates.sum, double(aggregates.counters.aggregates)) << technique;
            EXPECT_GT(aggregates.counters.aggregates, aggregates.counters.shadedPixels);
        }
}

// Half the space is lit, by a function that says so.
TEST(DebugView, LitIsTheShareOfLight) {
    StageContext context;
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl = "float agaaHostShadow(uint shadow, vec3 position) { return position.x > 0.0 ? 1.0 : 0.25; }";
    function.shadows = 1;
    for (const char* technique : {"ssaa", "agaa"}) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.debugView = AGAA_DEBUG_VIEW_LIT;
        settings.facts.shadowMapCount = 1;
        settings.chained = &function;
        StageView host(context, settings);
        host.setTriangles(randomTriangles({.triangles = 150}, 61));
        const AgaaShadow shadow{};
        AgaaFrame frame = host.frame();
        frame.shadows = &shadow;
        frame.shadowCount = 1;
        host.render(frame);
        const harness::Image image = host.image();
        size_t lit = 0, dim = 0;
        for (size_t i = 0; i < image.rgb.size(); i += 3) {
            const size_t x = i / 3 % image.width;
            const float value = image.rgb[i];
            if (value == 0 || x == image.width / 2 || x + 1 == image.width / 2)
                continue; // no geometry; or the plane between
            ASSERT_NEAR(value, x > image.width / 2 ? 1.0f : 0.25f, 1e-3f) << technique << ' ' << x;
            ++(x > image.width / 2 ? lit : dim);
        }
        EXPECT_GT(lit, 100u);
        EXPECT_GT(dim, 100u);
    }
}

TEST(DebugView, SharesLieInTheirRange) {
    StageContext context;
    for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER}) {
        const Shown lit = show(context, "agaa", tier, AGAA_DEBUG_VIEW_LIT); // without shadows everything is
        EXPECT_NEAR(lit.sum, double(lit.counters.shadedPixels), 1e-3 * lit.sum);
        const Shown widened = show(context, "agaa", tier, AGAA_DEBUG_VIEW_WIDENED);
        EXPECT_GT(widened.counters.widenedLobes, 0u);
        EXPECT_GT(widened.sum, 0);
        for (float value : widened.image.rgb) {
            ASSERT_GE(value, 0);
            ASSERT_LE(value, 1);
        }
    }
}

// A pixel of one aggregate has its colour, one of several a mixture.
TEST(DebugView, ColoursTellClustersAndTiersApart) {
    StageContext context;
    const Shown clusters = show(context, "agaa", AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_CLUSTERS);
    const Shown number = show(context, "agaa", AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_AGGREGATES);
    size_t whole = 0, mixed = 0;
    for (size_t i = 0; i < clusters.image.rgb.size(); i += 3) {
        const bool isFirst = std::fabs(clusters.image.rgb[i + 2] - 0.45f) < 2e-3f && clusters.image.rgb[i] < 1e-3f;
        if (number.image.rgb[i] == 1) {
            ASSERT_TRUE(isFirst);
            ++whole;
        } else if (number.image.rgb[i] > 1) {
            ASSERT_FALSE(isFirst);
            ++mixed;
        }
    }
    EXPECT_GT(whole, 0u);
    EXPECT_GT(mixed, 0u);
    const Shown two = show(context, "agaa", AGAA_TIER_AUTO, AGAA_DEBUG_VIEW_TIER);
    const Shown gbuffer = show(context, "agaa", AGAA_TIER_GBUFFER, AGAA_DEBUG_VIEW_TIER);
    const auto expectColour = [&](const Shown& shown, glm::vec3 colour) {
        for (size_t i = 0; i < number.image.rgb.size(); i += 3)
            for (size_t c = 0; c < 3; ++c) {
                const float events = number.image.rgb[i];
                const float bright = events == 0 ? 0.0f : events == 1 ? 0.5f : 1.0f;
                ASSERT_NEAR(shown.image.rgb[i + c], bright * colour[int(c)], 2e-3f);
            }
    };
    expectColour(two, {0.9f, 0.4f, 0.0f});
    size_t blue = 0; // shading normals part other pixels than geometric ones do
    for (size_t i = 0; i < gbuffer.image.rgb.size(); i += 3) {
        ASSERT_EQ(gbuffer.image.rgb[i], 0);
        blue += gbuffer.image.rgb[i + 2] > 0.4f;
    }
    EXPECT_EQ(blue, gbuffer.counters.shadedPixels);
}

} // namespace
} // namespace agaa::test
