// Numerically hard geometry through the whole pipeline, by every generation tier. Each graphics API instantiates these.
#pragma once

#include "agreement.h"
#include "hard_case_test.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace agaa::test {

template <class Host> class HardGeometryCases : public HardCaseTest<Host> {};
TYPED_TEST_SUITE_P(HardGeometryCases);

TYPED_TEST_P(HardGeometryCases, HardCase18AnEmptyFrameIsTheBackground) {
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
TYPED_TEST_P(HardGeometryCases, HardCase17GeometryAtTheFarPlaneIsSeen) {
    for (const Setting& s : hardSettings)
        for (bool reversed : {false, true}) {
            if (!this->renders(s, reversed))
                continue;
            ViewSettings view = pixelView(s);
            if (reversed) {
                view.flags = AGAA_VIEW_REVERSED_Z;
                view.projection[2][2] = 1.0f / 10;
                view.projection[3][2] = 1;
            }
            const float depth = std::nextafter(10.0f, 0.0f);
            const Shown r = this->render(view, rectangle(0, 0, 32, 16, depth, facing({1, 1, 1})), {sun()});
            EXPECT_EQ(nonFinite(r.rgb), 0u);
            EXPECT_EQ(r.counters.visible, uint64_t(32 * 16) * s.n) << s << reversed;
            EXPECT_EQ(r.counters.once, r.counters.visible);
        }
}

// A wall that runs into the far plane: where its depth rounds to the value that was cleared, every technique shows the
// background.
TYPED_TEST_P(HardGeometryCases, HardCase17DepthThatRoundsToTheFarPlaneIsBackground) {
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
    // An NVIDIA H200 rounds none of it to 1.
    if (isInOrder(typename TypeParam::Context().caps())) {
        EXPECT_LT(truth.counters.visible, uint64_t(48 * 32 * 8 * 99 / 100)) << "part of the wall is at the far plane";
    }
    for (const Setting& s : {Setting{"simple_complex", 8},
                             {"adaptive", 8},
                             {"msaa", 8},
                             {"sbaa", 8},
                             {"agaa", 8},
                             {"agaa", 8, AGAA_TIER_PER_SAMPLE},
                             {"agaa", 8, AGAA_TIER_GBUFFER},
                             {"agaa", 8, AGAA_TIER_IDS}}) {
        const Shown r = shown(s);
        EXPECT_EQ(r.counters.once, r.counters.visible) << s;
        EXPECT_EQ(r.counters.uncovered + r.counters.overlapping, 0u) << s;
        if (std::string(s.technique) == "msaa") {
            // It finds the far plane by the depth that it reads, and Mesa reads the last step of 24 bits as 1: it loses
            // that step, which on this wall is wide.
            EXPECT_LE(r.counters.visible, truth.counters.visible);
            EXPECT_GE(r.counters.visible, truth.counters.visible / 3);
            continue;
        }
        EXPECT_EQ(r.counters.visible, truth.counters.visible) << s;
        EXPECT_GE(compare(r.rgb, truth.rgb).psnr, 45) << s;
    }
}

// A surface that a host puts at the far plane, of depth 0 where z is reversed, is background, too, but where it is
// drawn twice (AgaaFrame::projection).
TYPED_TEST_P(HardGeometryCases, HardCase17SurfacesPutAtTheFarPlaneAreBackground) {
    for (const Setting& s : {Setting{"single", 1},
                             {"ssaa", 8},
                             {"msaa", 8},
                             {"sbaa", 8},
                             {"agaa", 8, AGAA_TIER_GBUFFER},
                             {"agaa", 8, AGAA_TIER_IDS}}) {
        ViewSettings view = pixelView(s);
        view.flags = AGAA_VIEW_REVERSED_Z;
        view.projection[2][2] = 1.0f / 16; // exact, so that depth is exactly 0
        view.projection[3][2] = 1;
        std::vector<Triangle> scene = rectangle(0, 0, 32, 16, 16, facing({1, 1, 1}));
        const auto near = rectangle(0, 0, 16, 16, 5, facing({1, 1, 1}));
        scene.insert(scene.end(), near.begin(), near.end());
        const Shown r = this->render(view, scene, {sun()});
        EXPECT_EQ(r.counters.visible, uint64_t(16 * 16) * s.n) << s;
        EXPECT_EQ(r.counters.once, r.counters.visible) << s;
        EXPECT_EQ(r.counters.uncovered + r.counters.overlapping, 0u) << s;
        EXPECT_EQ(r.rgb[3 * 20], 0.25f) << s;
    }
}

// One sample of a pixel: no variance, no widening, the colour's nth part.
TYPED_TEST_P(HardGeometryCases, HardCase19OneCoveredSampleIsThatSample) {
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

// Triangles through the eye's plane, of no area, and of no width.
TYPED_TEST_P(HardGeometryCases, HardCase48And50DegenerateTriangles) {
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
        if (!this->renders(s))
            continue;
        ViewSettings view;
        view.config.technique = s.technique;
        view.config.samples = s.n;
        view.config.generationTier = s.tier;
        const Shown r = this->render(view, scene, {sun()});
        EXPECT_EQ(nonFinite(r.rgb), 0u) << s;
        EXPECT_EQ(r.counters.once, r.counters.visible);
        EXPECT_EQ(r.counters.uncovered + r.counters.overlapping, 0u);
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

TYPED_TEST_P(HardGeometryCases, HardCase48SliversCountOnce) {
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
            EXPECT_EQ(r.counters.uncovered + r.counters.overlapping, 0u) << seed << ' ' << agaaTierName(tier);
            EXPECT_EQ(nonFinite(r.rgb), 0u);
            visible = visible ? visible : r.counters.visible;
            EXPECT_EQ(r.counters.visible, visible);
        }
    }
}

// Two coplanar masked surfaces share samples. The first sample of each may route it to another aggregate: what the
// first has, the second must not have again.
TYPED_TEST_P(HardGeometryCases, HardCase25RoutedDuplicatesCountOnce) {
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
        view.config.aggregation.characteristicLength = 0.02f;
        view.config.aggregation.characteristicLengthPerDistance = 0;
        view.config.flags = AGAA_CONFIG_SPLIT_SURFACES;
        view.config.measurement.flags = routes ? AGAA_MEASURE_FIRST_SAMPLE_ROUTING : 0;
        const Shown r = this->render(view, scene, {sun()});
        // A fragment's first sample depends on the positions of the samples.
        const double several = routes && !isInOrder(typename TypeParam::Context().caps()) ? 1.5 : 2;
        EXPECT_GT(double(r.counters.shadingEvents), several * double(r.counters.shadedPixels))
            << "there are several aggregates";
        EXPECT_GT(r.counters.ties, 0u);
        EXPECT_EQ(r.counters.once, r.counters.visible);
        EXPECT_EQ(r.counters.overlapping, 0u) << (routes ? "routed" : "split");
        EXPECT_TRUE(r.validation.isValid) << r.validation.explanation;
    }
}

// `msaa` shows the first of coplanar draws in each sample, like techniques with a G-buffer. This includes masked
// materials, whose stencil test would come before their mask.
TYPED_TEST_P(HardGeometryCases, HardCase25CoplanarDrawsOfMsaaShowTheFirst) {
    struct Layer {
        glm::vec3 colour;
        bool isMasked;
    };
    const Layer masked[] = {{{1, 0, 0}, true}, {{0, 1, 0}, true}, {{0, 0, 1}, true}};
    const Layer opaqueFirst[] = {{{1, 0, 0}, false}, {{0, 1, 0}, true}};
    const Layer maskedFirst[] = {{{1, 0, 0}, true}, {{0, 1, 0}, false}};
    for (const std::span<const Layer> layers :
         {std::span<const Layer>(masked), std::span<const Layer>(opaqueFirst), std::span<const Layer>(maskedFirst)}) {
        std::vector<Triangle> scene;
        for (const Layer& layer : layers)
            for (Triangle& t : rectangle(0, 0, 32, 16, 5, facing(layer.colour))) {
                t.material.diffuse.w = layer.isMasked ? 0.5f : 1.0f;
                t.isMasked = layer.isMasked;
                t.seed = 11 * uint32_t(scene.size() / 2) + 1;
                scene.push_back(t);
            }
        for (const uint32_t n : {4u, 8u, 32u})
            for (const uint64_t flags : {uint64_t(0), uint64_t(AGAA_MEASURE_NO_STENCIL)}) {
                if (!rendersSetting<TypeParam>(layers.size() + n / 8 + (flags != 0)))
                    continue;
                ViewSettings view = pixelView({"msaa", n});
                view.config.measurement.flags |= flags;
                const Shown shown = this->render(view, scene, {sun()});
                view.config.technique = "ssaa";
                const Shown truth = this->render(view, scene, {sun()});
                EXPECT_GE(compare(shown.rgb, truth.rgb).psnr, 60) << "n=" << n << " flags=" << flags;
                EXPECT_EQ(shown.counters.visible, truth.counters.visible);
                EXPECT_EQ(shown.counters.once, shown.counters.visible);
                if (flags)
                    continue;
                // Blending keeps the first of masked fragments, so each layer is shaded, as often as an opaque one.
                view.config.technique = "msaa";
                const Shown opaque = this->render(view, rectangle(0, 0, 32, 16, 5, facing({1, 0, 0})), {sun()});
                EXPECT_LE(shown.counters.shadingEvents, layers.size() * opaque.counters.shadingEvents);
            }
    }
}

// Strips of a third of a pixel lie behind a wall and fall by a third of the view's depth. Their planes are in front of
// the wall at the other samples of the pixel.
TYPED_TEST_P(HardGeometryCases, HardCase45EdgeOnStripsStayBehindAWall) {
    const std::vector<Triangle> wall = rectangle(-5, -5, 40, 20, 5, facing({0.25f, 0.5f, 0.75f}));
    std::vector<Triangle> scene;
    for (int column = 0; column < 32; ++column) {
        const float left = float(column) + 0.02f * float(column), width = column % 2 ? 0.3f : -0.3f;
        std::vector<Triangle> strip = rectangle(left, 0, left + 0.3f, 16, 6, facing({1, 1, 1}));
        for (Triangle& t : strip)
            for (glm::vec3& corner : t.position)
                corner.z = (corner.x > left + 0.15f) == (width > 0) ? -9.0f : -5.5f;
        scene.insert(scene.end(), strip.begin(), strip.end());
    }
    scene.insert(scene.end(), wall.begin(), wall.end());
    for (const Setting& s : {Setting{"ssaa", 8},
                             {"agaa", 8, AGAA_TIER_IDS},
                             {"agaa", 64, AGAA_TIER_FRAGMENTS},
                             {"dcaa", 64, AGAA_TIER_FRAGMENT_LISTS},
                             {"dcaa", 64, AGAA_TIER_MATERIAL_LISTS}}) {
        const Shown alone = this->render(pixelView(s), wall, {sun()});
        const Shown both = this->render(pixelView(s), scene, {sun()});
        EXPECT_EQ(both.rgb, alone.rgb) << s;
    }
}

// A sheet of triangles hides walls that are seen edge-on, whose depths change by the whole range within a pixel, and a
// plane. Walls must not merge with the sheet, and nothing may leak at the edges of its triangles.
TYPED_TEST_P(HardGeometryCases, HardCase46And52NothingLeaksThroughASheet) {
    std::mt19937 random(46);
    const auto uniform = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    Material sheet = facing({0, 0, 0}), behind = sheet;
    sheet.emissive = glm::vec4(0, 0, 1, 0);
    behind.emissive = glm::vec4(1, 0, 0, 0);
    constexpr int columns = 12, rows = 8;
    glm::vec3 grid[rows + 1][columns + 1];
    for (int r = 0; r <= rows; ++r)
        for (int c = 0; c <= columns; ++c)
            grid[r][c] = {4.0f * float(c) - 6 + uniform(-0.9f, 0.9f), 4.0f * float(r) - 6 + uniform(-0.9f, 0.9f),
                          uniform(-3, -2)};
    std::vector<Triangle> scene = rectangle(-10, -10, 42, 26, 9.5f, behind);
    for (int i = 0; i < 40; ++i) {
        Triangle wall;
        const float x = uniform(0, 32), width = i % 2 ? 1e-3f : 0.05f;
        wall.position[0] = {x, -5, -4};
        wall.position[1] = {x + uniform(-1, 1), 21, -4};
        wall.position[2] = wall.position[1] + glm::vec3(width, 0, -5);
        wall.material = behind;
        scene.push_back(wall);
    }
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            for (const bool isSecond : {false, true}) {
                Triangle t;
                t.position[0] = grid[r][c];
                t.position[1] = isSecond ? grid[r + 1][c + 1] : grid[r][c + 1];
                t.position[2] = isSecond ? grid[r + 1][c] : grid[r + 1][c + 1];
                t.material = sheet;
                scene.push_back(t);
            }
    for (const Setting& s : {Setting{"agaa", 8}, {"dcaa", 64}, {"agaa", 64, AGAA_TIER_FRAGMENTS}}) {
        const Shown r = this->render(pixelView(s, 4), scene, {});
        double leaked = 0, shown = 0;
        for (size_t i = 0; i < r.rgb.size(); i += 3) {
            leaked += double(r.rgb[i]) * s.n;
            shown += double(r.rgb[i + 2]);
        }
        EXPECT_NEAR(shown, 32 * 16, 0.1) << s;
        // Near a vertex rounded edges may miss a sample.
        EXPECT_LE(leaked, 2.01) << s;
        EXPECT_EQ(nonFinite(r.rgb), 0u) << s;
    }
}

// A strip of a quarter of a pixel falls through a plane in its middle: half of its samples are in front of the plane.
// A depth plane that is flattened around the pixel's centre has all or none of them in front, by the strip's half of
// the pixel.
TYPED_TEST_P(HardGeometryCases, HardCase61StripsOfAFractionOfAPixelCrossAPlane) {
    constexpr float width = 0.25f, middle = 6, extent = 4;
    const float starts[] = {0, 0.125f, 0.25f}; // from the left edge of a half of the pixel
    Material plane = facing({0, 0, 0}), strip = plane;
    plane.emissive = glm::vec4(1, 0, 0, 0);
    strip.emissive = glm::vec4(0, 0, 1, 0);
    std::vector<Triangle> scene = rectangle(0, 0, 32, 16, middle, plane);
    for (int x = 0; x < 32; ++x) {
        const float from = float(x) + (x < 16 ? 0 : 0.5f) + starts[x % 3];
        for (Triangle t : rectangle(from, 0, from + width, 16, middle, strip)) {
            for (glm::vec3& p : t.position)
                p.z += p.x > from + width / 2 ? -extent / 2 : extent / 2; // away from the eye, to the right
            scene.push_back(t);
        }
    }
    for (const Setting& s : {Setting{"agaa", 64, AGAA_TIER_FRAGMENTS}, {"dcaa", 64}, {"dcaa", 128}}) {
        const Shown r = this->render(pixelView(s, 4), scene, {});
        for (const int half : {0, 1}) {
            double front = 0;
            for (int x = 16 * half; x < 16 * half + 16; ++x)
                for (int y = 0; y < 16; ++y)
                    front += double(r.rgb[3 * size_t(32 * y + x) + 2]) / 16;
            const double truth = 16 * double(width) / 2;
            EXPECT_NEAR(front, truth, 0.02 * truth) << s << ", half " << half;
        }
        EXPECT_EQ(nonFinite(r.rgb), 0u) << s;
    }
}

// Sums of integers do not depend on the order of the fragments. Only samples where two fragments have equal depth may
// change.
TYPED_TEST_P(HardGeometryCases, HardCase35OrderOfDrawsChangesNoSum) {
    const std::vector<Triangle> scene = randomTriangles({.triangles = 200}, 35);
    std::vector<Triangle> shuffled = scene;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(35));
    for (const Setting& s : {Setting{"agaa", 8}, {"agaa", 32}}) {
        ViewSettings view;
        view.config.technique = s.technique;
        view.config.samples = s.n;
        view.config.measurement.flags = AGAA_MEASURE_NO_STENCIL; // so that ties are counted
        const Shown first = this->render(view, scene, {sun()}), second = this->render(view, shuffled, {sun()});
        uint64_t changed = 0;
        for (size_t i = 0; i < first.rgb.size(); i += 3)
            changed += std::memcmp(&first.rgb[i], &second.rgb[i], 3 * sizeof(float)) != 0;
        EXPECT_LE(changed, first.counters.ties) << s;
        EXPECT_LE(first.counters.ties, first.counters.visible / 1000) << s;
    }
}

// The same image at any size, by one pixel and by many.
TYPED_TEST_P(HardGeometryCases, HardCase55OddSizesAreWhole) {
    for (const Setting& s : hardSettings)
        for (const auto& [width, height] :
             {std::pair{1u, 1u}, {3u, 5u}, s.n == 8 ? std::pair{4097u, 3u} : std::pair{129u, 1u}, {1u, 77u}}) {
            if (!this->renders(s, (width + height) / 2))
                continue;
            ViewSettings view = pixelView(s);
            view.width = width;
            view.height = height;
            view.projection = pixelOrthographic(float(width), float(height), 10);
            const Shown r =
                this->render(view, rectangle(0, 0, float(width), float(height), 1, facing({1, 1, 1})), {sun()});
            EXPECT_EQ(r.counters.visible, uint64_t(width) * height * s.n) << s;
            for (float value : r.rgb)
                EXPECT_NEAR(value, 3 / 3.14159265f, 1e-3f) << s;
        }
}

REGISTER_TYPED_TEST_SUITE_P(HardGeometryCases, HardCase18AnEmptyFrameIsTheBackground,
                            HardCase17GeometryAtTheFarPlaneIsSeen, HardCase17DepthThatRoundsToTheFarPlaneIsBackground,
                            HardCase17SurfacesPutAtTheFarPlaneAreBackground, HardCase19OneCoveredSampleIsThatSample,
                            HardCase48And50DegenerateTriangles, HardCase48SliversCountOnce,
                            HardCase25RoutedDuplicatesCountOnce, HardCase25CoplanarDrawsOfMsaaShowTheFirst,
                            HardCase45EdgeOnStripsStayBehindAWall, HardCase46And52NothingLeaksThroughASheet,
                            HardCase61StripsOfAFractionOfAPixelCrossAPlane, HardCase35OrderOfDrawsChangesNoSum,
                            HardCase55OddSizesAreWhole);

} // namespace agaa::test
