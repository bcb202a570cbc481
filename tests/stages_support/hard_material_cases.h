// Numerically hard materials and lights through the whole pipeline, by every generation tier. Each graphics API
// instantiates these.
#pragma once

#include "hard_case_test.h"

#include <cmath>
#include <limits>

namespace agaa::test {

template <class Host> class HardMaterialCases : public HardCaseTest<Host> {};
TYPED_TEST_SUITE_P(HardMaterialCases);

// Dark colours do not vanish in the sums.
TYPED_TEST_P(HardMaterialCases, HardCase32ADarkRampSurvives) {
    for (const Setting& s : aggregateSettings) {
        std::vector<Triangle> ramp;
        for (uint32_t x = 0; x < 32; ++x) {
            const float albedo = 0.04f * float(x) / 31;
            const auto column = rectangle(float(x), 0, float(x + 1), 16, 1, facing(glm::vec3(albedo)));
            ramp.insert(ramp.end(), column.begin(), column.end());
        }
        const Shown r = this->render(pixelView(s), ramp, {sun()});
        for (uint32_t x = 0; x < 32; ++x) {
            const float expected = 0.04f * float(x) / 31 * 3 / 3.14159265f;
            EXPECT_NEAR(r.rgb[3 * x], expected, 0.5f / 2047 * 3 / 3.14f) << x << ' ' << s;
        }
    }
}

// White made of n fragments of one sample each is white, exactly.
TYPED_TEST_P(HardMaterialCases, HardCase33WhiteStaysWhite) {
    for (const Setting& s : aggregateSettings) {
        if (!this->renders(s))
            continue;
        std::vector<Triangle> slivers; // 32 to a pixel
        for (uint32_t i = 0; i < 32 * 32; ++i) {
            const float x = float(i) / 32;
            const auto strip = rectangle(x, 0, x + 1.0f / 32, 16, 1, facing({1, 1, 1}));
            slivers.insert(slivers.end(), strip.begin(), strip.end());
        }
        const auto whole = rectangle(0, 0, 32, 16, 1, facing({1, 1, 1}));
        const Shown parts = this->render(pixelView(s), slivers, {sun()});
        const Shown one = this->render(pixelView(s), whole, {sun()});
        EXPECT_EQ(parts.rgb, one.rgb) << s;
        EXPECT_EQ(parts.counters.visible, uint64_t(32 * 16) * s.n);
    }
}

// NaN, infinity and values out of range in a material are counted and replaced, and change no other pixel. The guards
// run as the device's compiler leaves them (hard case 56).
TYPED_TEST_P(HardMaterialCases, HardCase37BadMaterialsAreContained) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const auto ground = rectangle(0, 0, 32, 16, 5, facing({0.5f, 0.5f, 0.5f}));
    for (const Setting& s : hardSettings) {
        if (!this->renders(s))
            continue;
        const Shown clean = this->render(pixelView(s), ground, {sun()});
        EXPECT_EQ(clean.counters.sanitised, 0u);
        for (float bad : {nan, infinity, -infinity}) {
            std::vector<Triangle> scene = ground;
            for (int attribute = 0; attribute < 5; ++attribute) {
                Material m = facing({0.5f, 0.5f, 0.5f});
                glm::vec4* vectors[] = {&m.diffuse, &m.specular, &m.emissive, &m.normal};
                if (attribute < 4)
                    vectors[attribute]->y = bad;
                else
                    m.normal.w = bad;
                const float x = 2 + 6 * float(attribute);
                const auto patch = rectangle(x + 0.3f, 4, x + 2.6f, 8, 1, m);
                scene.insert(scene.end(), patch.begin(), patch.end());
            }
            const Shown r = this->render(pixelView(s), scene, {sun()});
            EXPECT_EQ(nonFinite(r.rgb), 0u) << s;
            EXPECT_GT(r.counters.sanitised, 0u);
            for (uint32_t y = 0; y < 16; ++y)
                for (uint32_t x = 0; x < 32; ++x) {
                    const bool patch = y >= 4 && y < 8 && x >= 2 && (x - 2) % 6 < 3;
                    for (uint32_t i = 3 * (y * 32 + x); !patch && i < 3 * (y * 32 + x) + 3; ++i)
                        EXPECT_EQ(r.rgb[i], clean.rgb[i]) << s;
                }
        }
    }
}

// Opposite normals in one aggregate: no direction, and yet a finite colour.
TYPED_TEST_P(HardMaterialCases, HardCase4OpposedNormalsCancel) {
    for (const Setting& s : aggregateSettings) {
        if (!this->renders(s))
            continue;
        std::vector<Triangle> scene;
        for (uint32_t i = 0; i < 256; ++i) {
            Material m = facing({1, 1, 1});
            m.specular = glm::vec4(1);
            m.normal = glm::vec4(i % 2 ? 1.0f : -1.0f, 0, 0, 0.0001f);
            const float x = float(i) / 8;
            const auto strip = rectangle(x, 0, x + 0.125f, 16, 1, m);
            scene.insert(scene.end(), strip.begin(), strip.end());
        }
        const Shown r = this->render(pixelView(s, 1), scene, {sun()});
        EXPECT_EQ(nonFinite(r.rgb), 0u) << s;
        for (float value : r.rgb)
            EXPECT_TRUE(value >= 0 && value <= 3) << s << ": " << value << ", no more light than falls on it";
    }
}

// Lamps in the surface, and with cones of no width.
TYPED_TEST_P(HardMaterialCases, HardCase39And40LightsInSurfaces) {
    std::vector<AgaaLight> lights;
    for (uint32_t type : {AGAA_LIGHT_POINT, AGAA_LIGHT_SPOT}) {
        AgaaLight light{};
        light.type = type;
        light.shadowMap = AGAA_NO_SHADOW;
        light.position[0] = 8.5f;
        light.position[1] = 8.5f;
        light.position[2] = -1;
        light.direction[2] = -1;
        light.color[0] = light.color[1] = light.color[2] = 1;
        light.cosInner = light.cosOuter = 0.5f;
        lights.push_back(light);
        light.radius = 0.1f;
        lights.push_back(light);
    }
    for (const Setting& s : hardSettings) {
        const Shown r = this->render(pixelView(s), rectangle(0, 0, 32, 16, 1, facing({1, 1, 1})), lights);
        EXPECT_EQ(nonFinite(r.rgb), 0u) << s;
    }
}

// A scene and its lamp at several scales, with the intensity of the lamp that leaves radiance as it is.
TYPED_TEST_P(HardMaterialCases, HardCase66ScenesOfAnyScale) {
    for (const Setting& s : hardSettings) {
        if (!this->renders(s) || s.n == 1)
            continue;
        std::vector<float> expected;
        for (const float scale : {1.0f, 1e-6f, 1e6f}) {
            ViewSettings view = pixelView(s);
            view.projection = glm::scale(view.projection, glm::vec3(1 / scale));
            std::vector<Triangle> plane = rectangle(0, 0, 32, 16, 5, facing({1, 1, 1}));
            for (Triangle& t : plane)
                for (glm::vec3& corner : t.position)
                    corner *= scale;
            AgaaLight lamp{};
            lamp.type = AGAA_LIGHT_POINT;
            lamp.shadowMap = AGAA_NO_SHADOW;
            lamp.position[0] = 16 * scale;
            lamp.position[1] = 8 * scale;
            lamp.position[2] = -4 * scale;
            lamp.range = 100 * scale;
            lamp.radius = 0.1f * scale;
            lamp.color[0] = lamp.color[1] = lamp.color[2] = scale * scale;
            const Shown r = this->render(view, plane, {lamp});
            if (expected.empty())
                expected = r.rgb;
            EXPECT_GT(r.rgb[3 * (8 * 32 + 16)], 0.1f) << s;
            for (size_t i = 0; i < expected.size(); ++i)
                ASSERT_NEAR(r.rgb[i], expected[i], 1e-3f * expected[i] + 1e-6f) << s << " at scale " << scale;
        }
    }
}

// Effects that the scene does not need are not evaluated: a reflectance of 0 has no Fresnel term at grazing angles.
TYPED_TEST_P(HardMaterialCases, WithoutSpecularLightIsDiffuse) {
    const float far = std::sin(1.396263f), near = std::cos(1.396263f); // of 80 degrees, to the eye and to the light
    Material m = facing({0.2f, 0.4f, 0.8f});
    m.normal = glm::vec4(far, 0, near, 1);
    AgaaLight light = sun();
    const glm::vec3 toLight = 2.0f * near * glm::vec3(far, 0, near) - glm::vec3(0, 0, 1);
    for (int i = 0; i < 3; ++i)
        light.direction[i] = -toLight[i];
    for (const Setting& s : hardSettings) {
        if (!this->renders(s))
            continue;
        ViewSettings view = pixelView(s);
        view.facts.flags = 0;
        const Shown r = this->render(view, rectangle(0, 0, 32, 16, 5, m), {light});
        for (size_t i = 0; i < r.rgb.size(); ++i) {
            const float expected = m.diffuse[int(i % 3)] * near * light.color[i % 3] / 3.14159265f;
            ASSERT_NEAR(r.rgb[i] / expected, 1, 0.03f) << s;
        }
    }
}

// A normal that is no number is none, as one of length 0.
TYPED_TEST_P(HardMaterialCases, NormalsWithoutADirectionFaceAlongZ) {
    for (const Setting& s : hardSettings) {
        if (!this->renders(s))
            continue;
        Material m = facing({0.5f, 0.5f, 0.5f});
        const Shown expected = this->render(pixelView(s), rectangle(0, 0, 32, 16, 5, m), {sun()});
        for (float x : {0.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            m.normal = glm::vec4(x, 0, x, 1);
            EXPECT_EQ(this->render(pixelView(s), rectangle(0, 0, 32, 16, 5, m), {sun()}).rgb, expected.rgb) << s << x;
        }
    }
}

// A normal along an axis is stored exactly, so that the peak of a mirror's lobe is as high as that of its samples.
TYPED_TEST_P(HardMaterialCases, MirrorsAlongAnAxisKeepTheirPeak) {
    Material m = facing({0, 0, 0});
    m.specular = glm::vec4(0.2f);
    m.normal.w = 0;
    const auto mirror = rectangle(0, 0, 32, 16, 5, m);
    const float peak = this->render(pixelView({"ssaa", 8}), mirror, {sun()}).rgb[0];
    EXPECT_GT(peak, 1000);
    for (const Setting& s : aggregateSettings)
        for (const uint64_t flags : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
            if (!this->renders(s, flags != 0))
                continue;
            ViewSettings view = pixelView(s);
            view.config.flags |= s.tier == AGAA_TIER_AUTO ? 0 : flags;
            for (const float value : this->render(view, mirror, {sun()}).rgb)
                ASSERT_NEAR(value / peak, 1, 0.01f) << s << flags;
        }
}

// A component of 0 is stored exactly: a light in the plane of a surface does not reach it, however bright it is.
TYPED_TEST_P(HardMaterialCases, LightsInThePlaneOfASurfaceDoNotReachIt) {
    const std::pair<glm::vec3, glm::vec3> cases[] = {
        {{0, 0, 1}, {1, 0, 0}}, {{0, -0.6f, 0.8f}, {-1, 0, 0}}, {{0.6f, 0, -0.8f}, {0, 1, 0}}};
    constexpr Setting settings[] = {
        {"ssaa", 8}, {"agaa", 32}, {"agaa", 8, AGAA_TIER_GBUFFER}, {"agaa", 8, AGAA_TIER_IDS}};
    for (const auto& [normal, direction] : cases)
        for (const Setting& s : settings) {
            Material m = facing({1, 1, 1});
            m.normal = glm::vec4(normal, 1);
            AgaaLight light = sun();
            for (int i = 0; i < 3; ++i) {
                light.direction[i] = direction[i];
                light.color[i] = 1e4f;
            }
            ViewSettings view = pixelView(s, 4);
            view.config.flags |= s.tier == AGAA_TIER_AUTO ? 0 : AGAA_CONFIG_BUFFERED;
            for (const float value : this->render(view, rectangle(0, 0, 32, 16, 5, m), {light}).rgb)
                ASSERT_EQ(value, 0) << s << ' ' << normal.x << ' ' << normal.y << ' ' << normal.z;
        }
}

// Hard case 34: emission beyond the layout's range of 16 keeps its hue, up to values that overflow half floats.
TYPED_TEST_P(HardMaterialCases, BrightEmissionKeepsItsHue) {
    Material m = facing({0, 0, 0});
    for (const float size : {64.0f, 65504.0f, 1e5f}) {
        m.emissive = glm::vec4(size, size / 2, size / 4, 0);
        for (const Setting& s : hardSettings) {
            if (size != 64 && s.n != 32)
                continue; // the sums of 32 samples are the largest
            const Shown r = this->render(pixelView(s), rectangle(0, 0, 32, 16, 5, m), {});
            for (int i = 0; i < 3; ++i)
                ASSERT_NEAR(r.rgb[size_t(i)], 16.0f / float(1 << i), 0.05f) << s << ' ' << size;
            EXPECT_EQ(r.counters.sanitised, 0u) << "finite values are not counted";
        }
    }
}

// The diffuse term is filtered by the spread of normals, but not of aggregates in memory whose roughness is folded into
// the length that would tell the spread.
TYPED_TEST_P(HardMaterialCases, FoldedAggregatesInMemoryHaveNoFilteredDiffuse) {
    std::vector<Triangle> scene;
    for (int i = 0; i < 64; ++i) {
        Material m = facing({1, 1, 1});
        m.normal = glm::vec4(i % 2 ? 0.8f : -0.8f, 0, 0.6f, 1);
        for (const Triangle& t : rectangle(float(i) / 2, 0, float(i + 1) / 2, 16, 5, m))
            scene.push_back(t);
    }
    AgaaLight light = sun();
    light.direction[0] = -1;
    light.direction[2] = 0;
    for (const char* name : {"precise", "paper16"})
        for (const Setting& s : {Setting{"agaa", 8}, Setting{"agaa", 8, AGAA_TIER_GBUFFER}}) {
            AgaaLayout layout = AGAA_LAYOUT_INIT;
            agaaGetBuiltinLayout(name, &layout);
            ViewSettings view = pixelView(s, 1);
            view.config.layout = &layout;
            const float filtered = this->render(view, scene, {light}).rgb[0];
            view.config.measurement.flags |= AGAA_MEASURE_NO_DIFFUSE_FILTER;
            const float plain = this->render(view, scene, {light}).rgb[0];
            if (std::strcmp(name, "paper16") == 0 && s.tier == AGAA_TIER_AUTO)
                EXPECT_EQ(filtered, plain);
            else
                EXPECT_GT(filtered, plain + 0.1f) << name << ' ' << s;
        }
}

// Shadow taps choose where shadows are looked up, not where an aggregate is shaded.
TYPED_TEST_P(HardMaterialCases, ShadowTapsDoNotMoveTheShading) {
    AgaaLight lamp = sun();
    lamp.type = AGAA_LIGHT_POINT;
    lamp.position[0] = 8;
    lamp.position[1] = 8;
    lamp.position[2] = -4.8f;
    for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
        ViewSettings view = pixelView({"agaa", 32, tier}, 1);
        view.config.shadowTaps = 1;
        const auto ground = rectangle(0, 0, 32, 16, 5, facing({1, 1, 1}));
        const Shown one = this->render(view, ground, {lamp});
        view.config.shadowTaps = 32;
        EXPECT_EQ(one.rgb, this->render(view, ground, {lamp}).rgb) << agaaTierName(tier);
    }
}

REGISTER_TYPED_TEST_SUITE_P(HardMaterialCases, HardCase32ADarkRampSurvives, HardCase33WhiteStaysWhite,
                            HardCase37BadMaterialsAreContained, HardCase4OpposedNormalsCancel,
                            HardCase39And40LightsInSurfaces, HardCase66ScenesOfAnyScale, WithoutSpecularLightIsDiffuse,
                            NormalsWithoutADirectionFaceAlongZ, MirrorsAlongAnAxisKeepTheirPeak,
                            LightsInThePlaneOfASurfaceDoNotReachIt, BrightEmissionKeepsItsHue,
                            FoldedAggregatesInMemoryHaveNoFilteredDiffuse, ShadowTapsDoNotMoveTheShading);

} // namespace agaa::test
