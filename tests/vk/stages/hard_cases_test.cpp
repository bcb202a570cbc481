// Numerically hard input through the whole pipeline.
#include "stage_host.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace agaa::test {
namespace {

struct Rendered {
    harness::Image image;
    AgaaCounters counters{};
};

Rendered render(ViewSettings settings, const std::vector<Triangle>& scene,
                const std::vector<AgaaLight>& lights,
                const std::function<void(AgaaFrame&)>& change = nullptr) {
    StageContext context;
    settings.facts.shadowMapCount = 0;
    settings.config.flags |= AGAA_CONFIG_COUNTERS;
    StageView view(context, settings);
    view.setTriangles(scene);
    AgaaFrame frame = view.frame();
    frame.lights = lights.data();
    frame.lightCount = uint32_t(lights.size());
    const float background[4] = {0.25f, 0.5f, 0.75f, 1};
    std::memcpy(frame.background, background, sizeof background);
    if (change)
        change(frame);
    view.render(frame);
    return {view.image(), view.statistics().counters};
}

size_t nonFinite(const harness::Image& image) {
    size_t count = 0;
    for (float value : image.rgb)
        count += !std::isfinite(value);
    return count;
}

ViewSettings pixelView(const char* technique, uint32_t n, uint32_t c = 2) {
    ViewSettings settings;
    settings.width = 32;
    settings.height = 16;
    settings.projection = pixelOrthographic(32, 16, 10);
    settings.config.technique = technique;
    settings.config.samples = n;
    settings.config.aggregates = c;
    return settings;
}

Material facing(const glm::vec3& diffuse) {
    Material m;
    m.diffuse = glm::vec4(diffuse, 1);
    m.specular = glm::vec4(0);
    m.normal = glm::vec4(0, 0, 1, 1);
    return m;
}

struct Setting {
    const char* technique;
    uint32_t n;
};
constexpr Setting settings[] = {{"single", 1}, {"ssaa", 8}, {"agaa", 1},  {"agaa", 4},
                                {"agaa", 8},   {"agaa", 16}, {"agaa", 32}};

TEST(GpuHardCases, HardCase18AnEmptyFrameIsTheBackground) {
    for (const Setting& s : settings) {
        const Rendered r = render(pixelView(s.technique, s.n), {}, {sun()});
        for (size_t i = 0; i < r.image.pixelCount(); ++i) {
            EXPECT_EQ(r.image.rgb[3 * i], 0.25f);
            EXPECT_EQ(r.image.rgb[3 * i + 1], 0.5f);
            EXPECT_EQ(r.image.rgb[3 * i + 2], 0.75f);
        }
        EXPECT_EQ(r.counters.shadingEvents, 0u);
    }
}

// At the far plane, and with a depth of exactly 1 or 0: geometry all the same.
TEST(GpuHardCases, HardCase17GeometryAtTheFarPlaneIsSeen) {
    for (const Setting& s : settings)
        for (bool reversed : {false, true}) {
            ViewSettings view = pixelView(s.technique, s.n);
            if (reversed) {
                view.flags = AGAA_VIEW_REVERSED_Z;
                view.projection[2][2] = 1.0f / 10;
                view.projection[3][2] = 1;
            }
            // A step before the clear value, which no comparison takes for geometry.
            const float depth = std::nextafter(10.0f, 0.0f);
            const Rendered r =
                render(view, rectangle(0, 0, 32, 16, depth, facing({1, 1, 1})), {sun()});
            EXPECT_EQ(nonFinite(r.image), 0u);
            EXPECT_EQ(r.counters.visible, uint64_t(32 * 16) * s.n) << s.technique << reversed;
            EXPECT_EQ(r.counters.once, r.counters.visible);
        }
}

// One sample of a pixel: no variance, no widening, the colour's nth part.
TEST(GpuHardCases, HardCase19OneCoveredSampleIsThatSample) {
    // A dot around one sample of the 4x pattern, in pixel (8, 4).
    Material m = facing({0.5f, 0.25f, 0.125f});
    m.specular = glm::vec4(0.3f);
    m.normal.w = 0.01f;
    const auto dot = rectangle(8.37f, 4.12f, 8.38f, 4.13f, 1, m);
    const Rendered samples = render(pixelView("ssaa", 4), dot, {sun()});
    const Rendered aggregates = render(pixelView("agaa", 4), dot, {sun()});
    EXPECT_EQ(samples.counters.visible, 1u);
    EXPECT_EQ(aggregates.counters.visible, 1u);
    EXPECT_EQ(aggregates.counters.widenedLobes, 0u);
    for (size_t i = 0; i < samples.image.rgb.size(); ++i)
        EXPECT_NEAR(samples.image.rgb[i], aggregates.image.rgb[i], 2e-3f);
}

// Dark colours do not vanish in the sums.
TEST(GpuHardCases, HardCase32ADarkRampSurvives) {
    for (uint32_t n : {4u, 8u, 16u, 32u}) {
        std::vector<Triangle> ramp;
        for (uint32_t x = 0; x < 32; ++x) {
            const float albedo = 0.04f * float(x) / 31;
            const auto column =
                rectangle(float(x), 0, float(x + 1), 16, 1, facing(glm::vec3(albedo)));
            ramp.insert(ramp.end(), column.begin(), column.end());
        }
        const Rendered r = render(pixelView("agaa", n), ramp, {sun()});
        for (uint32_t x = 0; x < 32; ++x) {
            const float expected = 0.04f * float(x) / 31 * 3 / 3.14159265f;
            EXPECT_NEAR(r.image.rgb[3 * x], expected, 0.5f / 2047 * 3 / 3.14f) << x << " n=" << n;
        }
    }
}

// White made of n fragments of one sample each is white, exactly.
TEST(GpuHardCases, HardCase33WhiteStaysWhite) {
    for (uint32_t n : {8u, 32u}) {
        std::vector<Triangle> slivers; // 32 to a pixel
        for (uint32_t i = 0; i < 32 * 32; ++i) {
            const float x = float(i) / 32;
            const auto strip = rectangle(x, 0, x + 1.0f / 32, 16, 1, facing({1, 1, 1}));
            slivers.insert(slivers.end(), strip.begin(), strip.end());
        }
        const auto whole = rectangle(0, 0, 32, 16, 1, facing({1, 1, 1}));
        const Rendered parts = render(pixelView("agaa", n), slivers, {sun()});
        const Rendered one = render(pixelView("agaa", n), whole, {sun()});
        EXPECT_EQ(parts.image.rgb, one.image.rgb);
        EXPECT_EQ(parts.counters.visible, uint64_t(32 * 16) * n);
    }
}

// NaN, infinity and values out of range in a material: counted, replaced, and felt by no other pixel.
TEST(GpuHardCases, HardCase37BadMaterialsAreContained) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const auto ground = rectangle(0, 0, 32, 16, 5, facing({0.5f, 0.5f, 0.5f}));
    for (const Setting& s : settings) {
        const Rendered clean = render(pixelView(s.technique, s.n), ground, {sun()});
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
            const Rendered r = render(pixelView(s.technique, s.n), scene, {sun()});
            EXPECT_EQ(nonFinite(r.image), 0u) << s.technique << " n=" << s.n;
            EXPECT_GT(r.counters.sanitised, 0u);
            for (uint32_t y = 0; y < 16; ++y)
                for (uint32_t x = 0; x < 32; ++x) {
                    const bool patch = y >= 4 && y < 8 && x >= 2 && (x - 2) % 6 < 3;
                    if (!patch) {
                        EXPECT_EQ(r.image.rgb[3 * (y * 32 + x)],
                                  clean.image.rgb[3 * (y * 32 + x)]);
                    }
                }
        }
    }
}

// Opposite normals in one aggregate: no direction, and yet a finite colour.
TEST(GpuHardCases, HardCase4OpposedNormalsCancel) {
    for (uint32_t n : {4u, 8u, 32u}) {
        std::vector<Triangle> scene;
        for (uint32_t i = 0; i < 256; ++i) {
            Material m = facing({1, 1, 1});
            m.specular = glm::vec4(1);
            m.normal = glm::vec4(i % 2 ? 1.0f : -1.0f, 0, 0, 0.0001f);
            const float x = float(i) / 8;
            const auto strip = rectangle(x, 0, x + 0.125f, 16, 1, m);
            scene.insert(scene.end(), strip.begin(), strip.end());
        }
        const Rendered r = render(pixelView("agaa", n, 1), scene, {sun()});
        EXPECT_EQ(nonFinite(r.image), 0u);
        for (float value : r.image.rgb)
            EXPECT_LE(value, 10.0f) << "no more light than falls on it";
    }
}

// Lamps in the surface, with cones of no width, and behind shadow maps that see nothing.
TEST(GpuHardCases, HardCase39And40LightsInSurfaces) {
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
    for (const Setting& s : settings) {
        const Rendered r = render(pixelView(s.technique, s.n),
                                  rectangle(0, 0, 32, 16, 1, facing({1, 1, 1})), lights);
        EXPECT_EQ(nonFinite(r.image), 0u) << s.technique << " n=" << s.n;
    }
}

// Triangles through the eye's plane, of no area, and of no width.
TEST(GpuHardCases, HardCase48And50DegenerateTriangles) {
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
    for (const Setting& s : settings) {
        ViewSettings view;
        view.config.technique = s.technique;
        view.config.samples = s.n;
        const Rendered r = render(view, scene, {sun()});
        EXPECT_EQ(nonFinite(r.image), 0u) << s.technique << " n=" << s.n;
        EXPECT_EQ(r.counters.once, r.counters.visible);
        EXPECT_EQ(r.counters.missed + r.counters.multi, 0u);
    }
}

// The same image at any size, by one pixel and by many.
TEST(GpuHardCases, HardCase55OddSizesAreWhole) {
    for (const Setting& s : settings)
        for (const auto& [width, height] : {std::pair{1u, 1u}, {3u, 5u}, {129u, 1u}, {1u, 77u}}) {
            ViewSettings view = pixelView(s.technique, s.n);
            view.width = width;
            view.height = height;
            view.projection = pixelOrthographic(float(width), float(height), 10);
            const Rendered r =
                render(view, rectangle(0, 0, float(width), float(height), 1, facing({1, 1, 1})),
                       {sun()});
            EXPECT_EQ(r.counters.visible, uint64_t(width) * height * s.n);
            for (float value : r.image.rgb)
                EXPECT_EQ(value, r.image.rgb[0]);
        }
}

} // namespace
} // namespace agaa::test
