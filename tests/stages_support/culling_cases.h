// Lights that are culled by tiles: the same image, bit for bit, with fewer evaluations. Each graphics API instantiates these.
#pragma once

#include "hard_case_test.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

namespace agaa::test {

// A sun, then point and spot lights among randomTriangles().
inline std::vector<AgaaLight> manyLights(uint32_t count, float range, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    std::vector<AgaaLight> lights = {sun()};
    while (lights.size() < count) {
        AgaaLight light = sun();
        const float z = 1 + 19 * unit(random);
        light.type = lights.size() % 3 == 2 ? AGAA_LIGHT_SPOT : AGAA_LIGHT_POINT;
        light.position[0] = z * (unit(random) - 0.5f) * 1.8f;
        light.position[1] = z * (unit(random) - 0.5f) * 1.2f;
        light.position[2] = -z;
        const glm::vec3 direction = glm::normalize(glm::vec3(unit(random), unit(random), unit(random)) - 0.5f);
        for (int axis = 0; axis < 3; ++axis) {
            light.direction[axis] = direction[axis];
            light.color[axis] = range * range * unit(random);
        }
        light.range = lights.size() % 16 == 5 ? 0 : range * (0.5f + unit(random)); // some without end
        light.cosInner = 0.95f;
        light.cosOuter = lights.size() % 2 ? 0.8f : -0.2f;
        light.radius = 0.01f;
        lights.push_back(light);
    }
    return lights;
}

template <class Host>
class CullingCases : public testing::Test {
protected:
    // Bit-equal images of both ways. Returns the share of evaluations that culling leaves.
    double expectNoDifference(ViewSettings settings, const Shot& shot) {
        settings.facts.maxLights = uint32_t(shot.lights.size());
        settings.facts.shadowMapCount = 0;
        const Shown culled = show(context, settings, shot);
        settings.config.measurement.flags |= AGAA_MEASURE_NO_LIGHT_CULLING;
        const Shown all = show(context, settings, shot);
        EXPECT_EQ(culled.rgb, all.rgb);
        EXPECT_EQ(culled.counters.shadingEvents, all.counters.shadingEvents);
        EXPECT_EQ(all.counters.lightEvaluations, all.counters.shadingEvents * shot.lights.size());
        EXPECT_LE(culled.counters.lightEvaluations, all.counters.lightEvaluations);
        EXPECT_GT(sumOf(all.rgb), 0);
        return double(culled.counters.lightEvaluations) / double(all.counters.lightEvaluations);
    }

    Shot shotOf(uint32_t lights, float range) const {
        return {.triangles = randomTriangles({.triangles = 150, .duplicates = 0.1f, .masked = 0.2f}, 61),
                .lights = manyLights(lights, range, 5), .change = addAmbient};
    }

    static ViewSettings settingsOf(const char* technique, uint32_t n, uint32_t aggregates = 2, uint32_t tier = AGAA_TIER_AUTO) {
        ViewSettings settings;
        settings.config.technique = technique;
        settings.config.samples = n;
        settings.config.aggregates = aggregates;
        settings.config.generationTier = tier;
        return settings;
    }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(CullingCases);

TYPED_TEST_P(CullingCases, ImagesAreBitEqual) {
    const Shot shot = this->shotOf(100, 1);
    for (const char* technique : {"single", "ssaa", "simple_complex", "adaptive", "agaa", "sbaa", "fxaa"}) {
        SCOPED_TRACE(technique);
        const uint32_t n = std::string(technique) == "single" || std::string(technique) == "fxaa" ? 1 : 8;
        const double left = this->expectNoDifference(this->settingsOf(technique, n), shot);
        std::printf("%s: %.2f of the evaluations\n", technique, left);
        EXPECT_LT(left, 0.5);
    }
    for (const uint32_t tier : {AGAA_TIER_IDS, AGAA_TIER_GBUFFER})
        for (const uint64_t flags : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
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

// Lists of fragments leave no depth.
TYPED_TEST_P(CullingCases, WithoutDepthAllLightsAreEvaluated) {
    Shot shot = this->shotOf(40, 1);
    EXPECT_EQ(this->expectNoDifference(this->settingsOf("dcaa", 32, 4), shot), 1);
}

TYPED_TEST_P(CullingCases, EachProjection) {
    const Shot shot = this->shotOf(64, 2);
    ViewSettings settings = this->settingsOf("agaa", 4);
    this->expectNoDifference(settings, shot);
    settings.flags = AGAA_VIEW_REVERSED_Z;
    settings.projection = reversedInfinite(60, 1.5f, 0.1f); // samples that show nothing are infinitely far
    EXPECT_LT(this->expectNoDifference(settings, shot), 0.9);
    settings.flags = 0;
    settings.projection = pixelOrthographic(48, 32, 30);
    this->expectNoDifference(settings, shot);
}

// Hard case 17: geometry at the far plane has the depth of samples that show nothing.
TYPED_TEST_P(CullingCases, GeometryAtTheFarPlaneIsLit) {
    Shot shot = this->shotOf(40, 3);
    shot.triangles = rectangle(0, 0, 48, 32, std::nextafter(10.0f, 0.0f), facing({1, 1, 1}));
    for (size_t i = 1; i < shot.lights.size(); ++i) {
        shot.lights[i].position[0] = float(i % 8) * 6;
        shot.lights[i].position[1] = float(i / 8) * 6;
        shot.lights[i].position[2] = -9.5f;
        shot.lights[i].range = 3;
    }
    for (const char* technique : {"ssaa", "agaa"}) {
        ViewSettings settings = this->settingsOf(technique, 4);
        settings.projection = pixelOrthographic(48, 32, 10);
        EXPECT_LT(this->expectNoDifference(settings, shot), 0.9);
    }
}

REGISTER_TYPED_TEST_SUITE_P(CullingCases, ImagesAreBitEqual, AnyNumberOfLights, WithoutDepthAllLightsAreEvaluated, EachProjection,
                            GeometryAtTheFarPlaneIsLit);

} // namespace agaa::test
