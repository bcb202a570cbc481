// Lights that are culled by tiles: the same image, bit for bit, with fewer evaluations. Each graphics API instantiates
// these.
#pragma once

#include "agreement.h"
#include "hard_case_test.h"

#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <cstdio>

namespace agaa::test {

template <class Host> class CullingCases : public testing::Test {
protected:
    // Bit-equal images of both ways. Returns the share of evaluations that culling leaves.
    double expectNoDifference(ViewSettings settings, const Shot& shot) {
        settings.facts.maxLights = uint32_t(shot.lights.size());
        settings.facts.shadowMapCount = 0;
        const Shown culled = show(context, settings, shot);
        settings.config.measurement.flags |= AGAA_MEASURE_NO_LIGHT_CULLING;
        const Shown all = show(context, settings, shot);
        expectSameImage(culled.rgb, all.rgb, context.caps(), 0);
        EXPECT_EQ(culled.counters.shadingEvents, all.counters.shadingEvents);
        EXPECT_EQ(all.counters.lightEvaluations, all.counters.shadingEvents * shot.lights.size());
        EXPECT_LE(culled.counters.lightEvaluations, all.counters.lightEvaluations);
        EXPECT_GT(sumOf(all.rgb), 0);
        return double(culled.counters.lightEvaluations) / double(all.counters.lightEvaluations);
    }

    Shot shotOf(uint32_t lights, float range) const {
        const RandomScene scene = {.triangles = 150, .duplicates = 0.1f, .masked = 0.2f};
        return {.triangles = settleTies(randomTriangles(scene, 61), context.caps()),
                .lights = manyLights(lights, range, 5),
                .change = addAmbient};
    }

    static ViewSettings settingsOf(const char* technique, uint32_t n, uint32_t aggregates = 2,
                                   uint32_t tier = AGAA_TIER_AUTO) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.samples = n;
        settings.config.aggregates = aggregates;
        settings.config.generationTier = tier;
        return settings;
    }

    // Techniques that shade coverage samples: merged surfaces, fragments, and aggregates of fragments.
    static std::vector<ViewSettings> coverageSettings() {
        std::vector<ViewSettings> all = {settingsOf("dcaa", 32, 4, AGAA_TIER_FRAGMENT_LISTS),
                                         settingsOf("dcaa", 32, 4, AGAA_TIER_FRAGMENT_LISTS),
                                         settingsOf("agaa", 32, 2, AGAA_TIER_FRAGMENTS)};
        all[1].config.coverage.flags = AGAA_COVERAGE_EXACT;
        return all;
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(CullingCases);

TYPED_TEST_P(CullingCases, ImagesAreBitEqual) {
    const Shot shot = this->shotOf(100, 1);
    size_t setting = 0;
    for (const char* technique :
         {"single", "ssaa", "simple_complex", "adaptive", "agaa", "sbaa", "fxaa", "visibility"}) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(technique);
        const uint32_t n = std::string(technique) == "single" || std::string(technique) == "fxaa" ? 1 : 8;
        const double left = this->expectNoDifference(this->settingsOf(technique, n), shot);
        std::printf("%s: %.2f of the evaluations\n", technique, left);
        EXPECT_LT(left, 0.5);
    }
    for (const uint32_t tier : {AGAA_TIER_IDS, AGAA_TIER_GBUFFER})
        for (const uint64_t flags : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
            if (!rendersSetting<TypeParam>(setting++ / 2 + (flags != 0)))
                continue;
            SCOPED_TRACE(tier);
            ViewSettings settings = this->settingsOf("agaa", 4, 2, tier);
            settings.config.flags |= flags;
            EXPECT_LT(this->expectNoDifference(settings, shot), 0.5);
        }
}

TYPED_TEST_P(CullingCases, AnyNumberOfLights) {
    for (const uint32_t lights : {1u, 7u, 8u, 31u, 32u, 33u, 1024u}) {
        SCOPED_TRACE(lights);
        const double left = this->expectNoDifference(this->settingsOf("ssaa", 2), this->shotOf(lights, 0.5f));
        if (lights < 8) {
            EXPECT_EQ(left, 1) << "so few are not culled";
        } else if (lights == 1024) {
            EXPECT_LT(left, 0.2);
        }
    }
}

// Lists of fragments leave no depth, so that the shading passes find the lights.
TYPED_TEST_P(CullingCases, CoverageSamplesFindTheirLights) {
    const Shot shot = this->shotOf(100, 1);
    struct Way {
        const char* technique;
        uint32_t tier;
        uint64_t coverage;
        uint32_t lanes;
    };
    for (size_t setting = 0; const auto& [technique, tier, coverage, lanes] :
                             {Way{"dcaa", AGAA_TIER_FRAGMENT_LISTS, 0, AGAA_LANES_AUTO},
                              {"dcaa", AGAA_TIER_FRAGMENT_LISTS, AGAA_COVERAGE_EXACT, AGAA_LANES_PIXEL},
                              {"dcaa", AGAA_TIER_FRAGMENT_LISTS, AGAA_COVERAGE_EXACT, AGAA_LANES_SAMPLE_SHARED},
                              {"dcaa", AGAA_TIER_MATERIAL_LISTS, AGAA_COVERAGE_EXACT, AGAA_LANES_AUTO},
                              {"agaa", AGAA_TIER_FRAGMENTS, 0, AGAA_LANES_PIXEL},
                              {"agaa", AGAA_TIER_FRAGMENTS, 0, AGAA_LANES_SAMPLE_SHARED}}) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(std::string(technique) + ", " + agaaTierName(tier) + ", setting " + std::to_string(setting));
        ViewSettings settings = this->settingsOf(technique, 32, technique[0] == 'd' ? 4 : 2, tier);
        settings.config.coverage.flags = coverage;
        settings.config.measurement.lanes = lanes;
        const double left = this->expectNoDifference(settings, shot);
        std::printf("%s, setting %zu: %.2f of the evaluations\n", technique, setting, left);
        EXPECT_LT(left, 0.5);
    }
}

TYPED_TEST_P(CullingCases, EachProjection) {
    const Shot shot = this->shotOf(64, 2);
    std::vector<ViewSettings> all = this->coverageSettings();
    all.push_back(this->settingsOf("agaa", 4));
    for (size_t setting = 0; ViewSettings & settings : all) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(settings.config.technique);
        EXPECT_LT(this->expectNoDifference(settings, shot), 0.9);
        settings.flags = AGAA_VIEW_REVERSED_Z;
        settings.projection = reversedInfinite(60, 1.5f, 0.1f); // samples that show nothing are infinitely far
        EXPECT_LT(this->expectNoDifference(settings, shot), 0.9);
        settings.flags = 0;
        settings.projection = pixelOrthographic(48, 32, 30);
        EXPECT_LT(this->expectNoDifference(settings, shot), 1);
    }
}

TYPED_TEST_P(CullingCases, AnySizeAndView) {
    for (size_t size = 0; const auto& [width, height] : {std::pair{17u, 5u}, {43u, 29u}, {8u, 8u}}) {
        SCOPED_TRACE(width);
        ViewSettings settings = this->settingsOf("agaa", 4);
        settings.width = width;
        settings.height = height;
        // As far from a rotation as views may be.
        settings.view =
            glm::mat4(1.0004f * glm::mat3(glm::rotate(glm::mat4(1), 0.2f, glm::normalize(glm::vec3(1, 2, 3)))));
        EXPECT_LT(this->expectNoDifference(settings, this->shotOf(40, 1)), 0.9);
        settings.config.technique = "ssaa";
        EXPECT_LT(this->expectNoDifference(settings, this->shotOf(40, 1)), 0.9);
        ViewSettings coverage = this->coverageSettings()[size++];
        coverage.width = width;
        coverage.height = height;
        coverage.view = settings.view;
        EXPECT_LT(this->expectNoDifference(coverage, this->shotOf(40, 1)), 0.95);
    }
}

// Views may have room for lights that frames do not have.
TYPED_TEST_P(CullingCases, FramesWithFewLightsEvaluateThem) {
    for (const uint32_t lights : {0u, 1u, 7u}) {
        Shot shot = this->shotOf(std::max(lights, 1u), 1);
        shot.lights.resize(lights);
        std::vector<ViewSettings> all = this->coverageSettings();
        all.push_back(this->settingsOf("ssaa", 2));
        for (size_t setting = lights; ViewSettings & settings : all) {
            if (!rendersSetting<TypeParam>(setting++))
                continue;
            settings.facts.maxLights = 64;
            settings.facts.shadowMapCount = 0;
            const Shown shown = show(this->context, settings, shot);
            EXPECT_EQ(shown.counters.lightEvaluations, shown.counters.shadingEvents * lights)
                << settings.config.technique;
            EXPECT_GT(sumOf(shown.rgb), 0);
        }
    }
}

// Of two shadows one belongs to a light that reaches the left half only. Images are bit-equal, with fewer taps.
TYPED_TEST_P(CullingCases, ShadowsOfLightsOutOfReachAreNotLookedUp) {
    AgaaShadowFunction function = AGAA_SHADOW_FUNCTION_INIT;
    function.glsl =
        "float agaaHostShadow(uint shadow, vec3 position) { return fract(position.x + position.y) > 0.5 ? 1.0 : 0.0; }";
    function.shadows = 3;
    const AgaaShadow shadows[2] = {};
    Shot shot = this->shotOf(20, 0.5f);
    shot.lights[0].shadowMap = 1;
    AgaaLight& lamp = shot.lights[1];
    lamp.type = AGAA_LIGHT_POINT;
    lamp.shadowMap = 0;
    lamp.position[0] = -12;
    lamp.position[2] = -12;
    lamp.range = 9;
    shot.change = [&](AgaaFrame& frame) {
        addAmbient(frame);
        frame.shadows = shadows;
        frame.shadowCount = 2;
    };
    std::vector<ViewSettings> all = this->coverageSettings();
    for (const auto& [technique, tier] : {std::pair{"ssaa", AGAA_TIER_AUTO},
                                          {"agaa", AGAA_TIER_PER_SAMPLE},
                                          {"agaa", AGAA_TIER_GBUFFER},
                                          {"agaa", AGAA_TIER_IDS}})
        all.push_back(this->settingsOf(technique, 4, 2, tier));
    all[5].config.aggregation.litShadows = 1;
    for (size_t setting = 0; ViewSettings & settings : all) {
        if (!rendersSetting<TypeParam>(setting++))
            continue;
        SCOPED_TRACE(std::string(settings.config.technique) + ' ' + agaaTierName(settings.config.generationTier));
        settings.facts.maxLights = 20;
        settings.facts.shadowMapCount = 2;
        settings.chained = &function;
        const Shown culled = show(this->context, settings, shot);
        settings.config.measurement.flags |= AGAA_MEASURE_NO_LIGHT_CULLING;
        const Shown all = show(this->context, settings, shot);
        expectSameImage(culled.rgb, all.rgb, this->context.caps(), 0);
        EXPECT_LT(culled.counters.shadowTaps, all.counters.shadowTaps * 9 / 10);
        EXPECT_GT(culled.counters.shadowTaps, all.counters.shadowTaps / 2) << "the sun reaches all";
    }
}

REGISTER_TYPED_TEST_SUITE_P(CullingCases, ShadowsOfLightsOutOfReachAreNotLookedUp, ImagesAreBitEqual, AnyNumberOfLights,
                            CoverageSamplesFindTheirLights, EachProjection, AnySizeAndView,
                            FramesWithFewLightsEvaluateThem);

} // namespace agaa::test
