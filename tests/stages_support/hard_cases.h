// Numerically hard input through the whole pipeline, by every generation tier. Each graphics API
// instantiates these.
#pragma once

#include "shown.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace agaa::test {

template <class Host>
class HardCases : public testing::Test {
protected:
    // Over a background of colours that tests know.
    static Shown render(ViewSettings settings, const std::vector<Triangle>& triangles,
                        const std::vector<AgaaLight>& lights) {
        typename Host::Context context;
        settings.facts.shadowMapCount = 0;
        return show(context, settings,
                    {.triangles = triangles, .lights = lights, .change = [](AgaaFrame& frame) {
                         const float background[4] = {0.25f, 0.5f, 0.75f, 1};
                         std::memcpy(frame.background, background, sizeof background);
                     }});
    }
};
TYPED_TEST_SUITE_P(HardCases);

inline Material facing(const glm::vec3& diffuse) {
    Material m;
    m.diffuse = glm::vec4(diffuse, 1);
    m.specular = glm::vec4(0);
    m.normal = glm::vec4(0, 0, 1, 1);
    return m;
}

struct Setting {
    const char* technique;
    uint32_t n;
    uint32_t tier = AGAA_TIER_AUTO;
};
constexpr Setting hardSettings[] = {{"single", 1},
                                    {"ssaa", 8},
                                    {"agaa", 1},
                                    {"agaa", 4},
                                    {"agaa", 8},
                                    {"agaa", 16},
                                    {"agaa", 32},
                                    {"agaa", 8, AGAA_TIER_GBUFFER},
                                    {"agaa", 8, AGAA_TIER_IDS},
                                    {"agaa", 32, AGAA_TIER_IDS}};
// Of agaa with several samples.
constexpr std::span<const Setting> aggregateSettings = std::span(hardSettings).subspan(3);
inline ViewSettings pixelView(const Setting& s, uint32_t c = 2) {
    ViewSettings settings;
    settings.width = 32;
    settings.height = 16;
    settings.projection = pixelOrthographic(32, 16, 10);
    settings.config.technique = s.technique;
    settings.config.samples = s.n;
    settings.config.aggregates = c;
    settings.config.generationTier = s.tier;
    return settings;
}
inline std::ostream& operator<<(std::ostream& out, const Setting& s) {
    return out << s.technique << " n=" << s.n << ' ' << agaaTierName(s.tier);
}

TYPED_TEST_P(HardCases, HardCase18AnEmptyFrameIsTheBackground) {
    for (const Setting& s : hardSettings) {
        const Shown r = this->render(pixelView(s), {}, {sun()});
        for (size_t i = 0; i < r.rgb.size() / 3; ++i) {
            EXPECT_EQ(r.rgb[3 * i], 0.25f);
            EXPECT_EQ(r.rgb[3 * i + 1], 0.5f);
            EXPECT_EQ(r.rgb[3 * i + 2], 0.75f);
        }
        EXPECT_EQ(r.counters.shadingEvents, 0u);
    }
}

// A step before the far plane, whose depth is the clear value: geometry all the same.
TYPED_TEST_P(HardCases, HardCase17GeometryAtTheFarPlaneIsSeen) {
    for (const Setting& s : hardSettings)
        for (bool reversed : {false, true}) {
            ViewSettings view = pixelView(s);
            if (reversed) {
                view.flags = AGAA_VIEW_REVERSED_Z;
                view.projection[2][2] = 1.0f / 10;
                view.projection[3][2] = 1;
            }
            const float depth = std::nextafter(10.0f, 0.0f);
            const Shown r =
                this->render(view, rectangle(0, 0, 32, 16, depth, facing({1, 1, 1})), {sun()});
            EXPECT_EQ(nonFinite(r.rgb), 0u);
            EXPECT_EQ(r.counters.visible, uint64_t(32 * 16) * s.n) << s << reversed;
            EXPECT_EQ(r.counters.once, r.counters.visible);
        }
}

// A wall that runs into the far plane: where its depth rounds to the value that was cleared, every technique shows the
// background.
TYPED_TEST_P(HardCases, HardCase17DepthThatRoundsToTheFarPlaneIsBackground) {
    std::vector<Triangle> wall = rectangle(-100, -100, 100, 100, 0, facing({1, 1, 1}));
    for (Triangle& t : wall)
        for (glm::vec3& corner : t.position)
            corner.z = corner.x < 0 ? -99.99f : -100.0f;
    const auto shown = [&](const Setting& s) {
        ViewSettings view;
        view.config.technique = s.technique;
        view.config.samples = s.n;
        view.config.generationTier = s.tier;
        return this->render(view, wall, {sun()});
    };
    const Shown truth = shown({"ssaa", 8});
    EXPECT_GT(truth.counters.visible, uint64_t(48 * 32 * 8 / 2));
    EXPECT_LT(truth.counters.visible, uint64_t(48 * 32 * 8 * 99 / 100)) << "part of the wall is at the far plane";
    for (const Setting& s : {Setting{"simple_complex", 8}, {"msaa", 8}, {"sbaa", 8}, {"agaa", 8},
                             {"agaa", 8, AGAA_TIER_PER_SAMPLE}, {"agaa", 8, AGAA_TIER_GBUFFER},
                             {"agaa", 8, AGAA_TIER_IDS}}) {
        const Shown r = shown(s);
        EXPECT_EQ(r.counters.once, r.counters.visible) << s;
        EXPECT_EQ(r.counters.missed + r.counters.multi, 0u) << s;
        if (std::string(s.technique) == "msaa")
            continue; // it finds the far plane by the depth that it reads, which Mesa rounds up by a step
        EXPECT_EQ(r.counters.visible, truth.counters.visible) << s;
        EXPECT_GE(compare(r.rgb, truth.rgb).psnr, 45) << s;
    }
}

// One sample of a pixel: no variance, no widening, the colour's nth part.
TYPED_TEST_P(HardCases, HardCase19OneCoveredSampleIsThatSample) {
    // A dot around one sample of the 4x pattern, in pixel (8, 4).
    Material m = facing({0.5f, 0.25f, 0.125f});
    m.specular = glm::vec4(0.3f);
    m.normal.w = 0.01f;
    const auto dot = rectangle(8.37f, 4.12f, 8.38f, 4.13f, 1, m);
    const Shown samples = this->render(pixelView({"ssaa", 4}), dot, {sun()});
    EXPECT_EQ(samples.counters.visible, 1u);
    for (uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
        const Shown aggregates = this->render(pixelView({"agaa", 4, tier}), dot, {sun()});
        EXPECT_EQ(aggregates.counters.visible, 1u);
        EXPECT_EQ(aggregates.counters.widenedLobes, 0u);
        for (size_t i = 0; i < samples.rgb.size(); ++i)
            EXPECT_NEAR(samples.rgb[i], aggregates.rgb[i], 2e-3f) << agaaTierName(tier);
    }
}

// Dark colours do not vanish in the sums.
TYPED_TEST_P(HardCases, HardCase32ADarkRampSurvives) {
    for (const Setting& s : aggregateSettings) {
        std::vector<Triangle> ramp;
        for (uint32_t x = 0; x < 32; ++x) {
            const float albedo = 0.04f * float(x) / 31;
            const auto column =
                rectangle(float(x), 0, float(x + 1), 16, 1, facing(glm::vec3(albedo)));
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
TYPED_TEST_P(HardCases, HardCase33WhiteStaysWhite) {
    for (const Setting& s : aggregateSettings) {
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

// NaN, infinity and values out of range in a material: counted, replaced, and felt by no other
// pixel.
TYPED_TEST_P(HardCases, HardCase37BadMaterialsAreContained) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const auto ground = rectangle(0, 0, 32, 16, 5, facing({0.5f, 0.5f, 0.5f}));
    for (const Setting& s : hardSettings) {
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
TYPED_TEST_P(HardCases, HardCase4OpposedNormalsCancel) {
    for (const Setting& s : aggregateSettings) {
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
TYPED_TEST_P(HardCases, HardCase39And40LightsInSurfaces) {
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
        const Shown r =
            this->render(pixelView(s), rectangle(0, 0, 32, 16, 1, facing({1, 1, 1})), lights);
        EXPECT_EQ(nonFinite(r.rgb), 0u) << s;
    }
}

// Triangles through the eye's plane, of no area, and of no width.
TYPED_TEST_P(HardCases, HardCase48And50DegenerateTriangles) {
    std::vector<Triangle> scene = randomTriangles({.triangles = 50}, 51);
    for (size_t i = 0; i < scene.size(); ++i) {
        Triangle& t = scene[i];
        if (i % 3 == 0)
            t.position[2] = t.position[1];
        if (i % 3 == 1)
            t.position[0].z = 3;
        if (i % 7 == 0)
            t.material.geometricNormal = glm::vec4(0);
    }
    for (const Setting& s : hardSettings) {
        ViewSettings view;
        view.config.technique = s.technique;
        view.config.samples = s.n;
        view.config.generationTier = s.tier;
        const Shown r = this->render(view, scene, {sun()});
        EXPECT_EQ(nonFinite(r.rgb), 0u) << s;
        EXPECT_EQ(r.counters.once, r.counters.visible);
        EXPECT_EQ(r.counters.missed + r.counters.multi, 0u);
    }
}

// Zero area, collinear corners, needles: what a rasteriser makes of them must be the same in both passes, and each
// sample counts once.
inline std::vector<Triangle> sliverTriangles(uint32_t count, uint32_t seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    std::vector<Triangle> list;
    for (uint32_t i = 0; i < count; ++i) {
        Triangle t;
        const float distance = uniform(1, 20);
        for (glm::vec3& corner : t.position)
            corner = distance * glm::vec3(uniform(-0.9f, 0.9f), uniform(-0.6f, 0.6f), uniform(-1.2f, -0.8f));
        const glm::vec3 along = t.position[1] - t.position[0];
        if (i % 5 == 0)
            t.position[2] = t.position[1];
        if (i % 5 == 1)
            t.position[2] = t.position[0] + uniform(-1, 2) * along;
        if (i % 5 == 2)
            t.position[2] = t.position[0] + uniform(0, 1) * along + 1e-4f * distance * glm::vec3(uniform(-1, 1));
        if (i % 5 == 3) // along the view, from the near to the far plane
            t.position[1] = t.position[0] * (100 / distance);
        if (i % 5 >= 3)
            t.position[2] = t.position[0] + 0.01f * distance * glm::vec3(uniform(-1, 1), uniform(-1, 1), 0);
        t.material = facing({uniform(0, 1), uniform(0, 1), uniform(0, 1)});
        const glm::vec3 n = glm::cross(along, t.position[2] - t.position[0]);
        const float length = glm::length(n);
        t.material.geometricNormal = glm::vec4(length > 0 ? n / length : glm::vec3(0), 0);
        list.push_back(t);
    }
    return list;
}

TYPED_TEST_P(HardCases, HardCase48SliversCountOnce) {
    for (const uint32_t seed : {1u, 2u}) {
        const std::vector<Triangle> scene = sliverTriangles(3000, seed);
        uint64_t visible = 0;
        for (const uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_IDS}) {
            ViewSettings view;
            view.config.samples = 32;
            view.config.aggregates = 4;
            view.config.generationTier = tier;
            const Shown r = this->render(view, scene, {sun()});
            EXPECT_EQ(r.counters.once, r.counters.visible) << seed << ' ' << agaaTierName(tier);
            EXPECT_EQ(r.counters.missed + r.counters.multi, 0u) << seed << ' ' << agaaTierName(tier);
            EXPECT_EQ(nonFinite(r.rgb), 0u);
            visible = visible ? visible : r.counters.visible;
            EXPECT_EQ(r.counters.visible, visible);
        }
    }
}

// Two coplanar masked surfaces share samples. The first sample of each may route it to another aggregate: what the
// first has, the second must not have again.
TYPED_TEST_P(HardCases, HardCase25RoutedDuplicatesCountOnce) {
    std::vector<Triangle> scene;
    for (uint32_t i = 0; i < 2; ++i) {
        Triangle t;
        t.position[0] = {-6, -4, -3};
        t.position[1] = {7, -4, -9};
        t.position[2] = {0, 9, -12};
        t.material = facing({0.3f, 0.6f, 0.9f});
        t.material.diffuse.w = 0.6f;
        t.material.geometricNormal = glm::vec4(planeNormal(t), 0);
        t.isMasked = true;
        t.seed = 7 + i;
        scene.push_back(t);
    }
    for (const bool routes : {false, true}) {
        ViewSettings view;
        view.config.aggregates = 4;
        view.config.characteristicLength = 0.02f;
        view.config.characteristicLengthPerDistance = 0;
        view.config.flags = AGAA_CONFIG_SPLIT_SURFACES | (routes ? AGAA_CONFIG_FIRST_SAMPLE_ROUTING : 0);
        const Shown r = this->render(view, scene, {sun()});
        EXPECT_GT(r.counters.shadingEvents, 2 * r.counters.shadedPixels) << "there are several aggregates";
        EXPECT_GT(r.counters.ties, 0u);
        EXPECT_EQ(r.counters.once, r.counters.visible);
        EXPECT_EQ(r.counters.multi, 0u) << (routes ? "routed" : "split");
        EXPECT_TRUE(r.validation.isValid) << r.validation.explanation;
    }
}

// The same image at any size, by one pixel and by many.
TYPED_TEST_P(HardCases, HardCase55OddSizesAreWhole) {
    for (const Setting& s : hardSettings)
        for (const auto& [width, height] : {std::pair{1u, 1u}, {3u, 5u}, {129u, 1u}, {1u, 77u}}) {
            ViewSettings view = pixelView(s);
            view.width = width;
            view.height = height;
            view.projection = pixelOrthographic(float(width), float(height), 10);
            const Shown r = this->render(
                view, rectangle(0, 0, float(width), float(height), 1, facing({1, 1, 1})), {sun()});
            EXPECT_EQ(r.counters.visible, uint64_t(width) * height * s.n) << s;
            for (float value : r.rgb)
                EXPECT_NEAR(value, 3 / 3.14159265f, 1e-3f) << s;
        }
}

// What the scene does not call for is not evaluated: no Fresnel term of a reflectance of 0 along a grazing surface.
TYPED_TEST_P(HardCases, WithoutSpecularLightIsDiffuse) {
    const float far = std::sin(1.396263f), near = std::cos(1.396263f); // of 80 degrees, to the eye and to the light
    Material m = facing({0.2f, 0.4f, 0.8f});
    m.normal = glm::vec4(far, 0, near, 1);
    AgaaLight light = sun();
    const glm::vec3 toLight = 2.0f * near * glm::vec3(far, 0, near) - glm::vec3(0, 0, 1);
    for (int i = 0; i < 3; ++i)
        light.direction[i] = -toLight[i];
    for (const Setting& s : hardSettings) {
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
TYPED_TEST_P(HardCases, NormalsWithoutADirectionFaceAlongZ) {
    for (const Setting& s : hardSettings) {
        Material m = facing({0.5f, 0.5f, 0.5f});
        const Shown expected = this->render(pixelView(s), rectangle(0, 0, 32, 16, 5, m), {sun()});
        for (float x : {0.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            m.normal = glm::vec4(x, 0, x, 1);
            EXPECT_EQ(this->render(pixelView(s), rectangle(0, 0, 32, 16, 5, m), {sun()}).rgb, expected.rgb) << s << x;
        }
    }
}

// A normal along an axis is stored exactly, so that the peak of a mirror's lobe is as high as that of its samples.
TYPED_TEST_P(HardCases, MirrorsAlongAnAxisKeepTheirPeak) {
    Material m = facing({0, 0, 0});
    m.specular = glm::vec4(0.2f);
    m.normal.w = 0;
    const auto mirror = rectangle(0, 0, 32, 16, 5, m);
    const float peak = this->render(pixelView({"ssaa", 8}), mirror, {sun()}).rgb[0];
    EXPECT_GT(peak, 1000);
    for (const Setting& s : aggregateSettings)
        for (const uint64_t flags : {uint64_t(0), AGAA_CONFIG_BUFFERED}) {
            ViewSettings view = pixelView(s);
            view.config.flags |= s.tier == AGAA_TIER_AUTO ? 0 : flags;
            for (const float value : this->render(view, mirror, {sun()}).rgb)
                ASSERT_NEAR(value / peak, 1, 0.01f) << s << flags;
        }
}

// A component of 0 is stored exactly: a light in the plane of a surface does not reach it, however bright it is.
TYPED_TEST_P(HardCases, LightsInThePlaneOfASurfaceDoNotReachIt) {
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

// Emission beyond the layout's range of 16 keeps its hue.
TYPED_TEST_P(HardCases, BrightEmissionKeepsItsHue) {
    Material m = facing({0, 0, 0});
    m.emissive = glm::vec4(64, 32, 16, 0);
    for (const Setting& s : hardSettings) {
        const Shown r = this->render(pixelView(s), rectangle(0, 0, 32, 16, 5, m), {});
        for (int i = 0; i < 3; ++i)
            ASSERT_NEAR(r.rgb[size_t(i)], 16.0f / float(1 << i), 0.05f) << s;
        EXPECT_EQ(r.counters.sanitised, 0u) << "finite values are not counted";
    }
}

// The diffuse term is filtered by the spread of normals, but not of aggregates in memory whose roughness is folded into
// the length that would tell the spread.
TYPED_TEST_P(HardCases, FoldedAggregatesInMemoryHaveNoFilteredDiffuse) {
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
            AgaaLayout layout;
            agaaGetBuiltinLayout(name, &layout);
            ViewSettings view = pixelView(s, 1);
            view.config.layout = &layout;
            const float filtered = this->render(view, scene, {light}).rgb[0];
            view.config.flags |= AGAA_CONFIG_NO_DIFFUSE_FILTER;
            const float plain = this->render(view, scene, {light}).rgb[0];
            if (std::strcmp(name, "paper16") == 0 && s.tier == AGAA_TIER_AUTO)
                EXPECT_EQ(filtered, plain);
            else
                EXPECT_GT(filtered, plain + 0.1f) << name << ' ' << s;
        }
}

// Shadow taps choose where shadows are looked up, not where an aggregate is shaded.
TYPED_TEST_P(HardCases, ShadowTapsDoNotMoveTheShading) {
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

REGISTER_TYPED_TEST_SUITE_P(HardCases, HardCase18AnEmptyFrameIsTheBackground,
                            HardCase17GeometryAtTheFarPlaneIsSeen,
                            HardCase17DepthThatRoundsToTheFarPlaneIsBackground,
                            HardCase19OneCoveredSampleIsThatSample, HardCase32ADarkRampSurvives,
                            HardCase33WhiteStaysWhite, HardCase37BadMaterialsAreContained,
                            HardCase4OpposedNormalsCancel, HardCase39And40LightsInSurfaces,
                            HardCase48And50DegenerateTriangles, HardCase25RoutedDuplicatesCountOnce,
                            HardCase55OddSizesAreWhole, WithoutSpecularLightIsDiffuse,
                            NormalsWithoutADirectionFaceAlongZ, MirrorsAlongAnAxisKeepTheirPeak,
                            LightsInThePlaneOfASurfaceDoNotReachIt, BrightEmissionKeepsItsHue,
                            FoldedAggregatesInMemoryHaveNoFilteredDiffuse, HardCase48SliversCountOnce,
                            ShadowTapsDoNotMoveTheShading);

} // namespace agaa::test
