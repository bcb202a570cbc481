// The technique "visibility": light of one sample per pixel for all. Each graphics API instantiates these.
#pragma once

#include "shown.h"

#include <cmath>

namespace agaa::test {

inline ViewSettings visibilitySettings(const char* technique, uint32_t n) {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.config.samples = n;
    settings.facts.shadowMapCount = 0;
    settings.projection = pixelOrthographic(48, 32, 10);
    return settings;
}

inline Material matte(const glm::vec3& diffuse, const glm::vec3& normal = {0, 0, 1}) {
    Material material;
    material.diffuse = glm::vec4(diffuse, 1);
    material.specular = glm::vec4(0);
    material.normal = glm::vec4(glm::normalize(normal), 1);
    return material;
}

template <class Host> class VisibilityCases : public testing::Test {
protected:
    // Expects the image of ssaa, but for the half floats of the shaded image and codes of reflectance.
    void expectSupersampled(const std::vector<Triangle>& triangles, double relative) {
        for (const uint32_t n : {1u, 4u, 8u}) {
            const Shot shot{.triangles = triangles};
            const Shown expected = show(context, visibilitySettings("ssaa", n), shot);
            const Shown found = show(context, visibilitySettings("visibility", n), shot);
            for (size_t i = 0; i < found.rgb.size(); ++i)
                ASSERT_NEAR(found.rgb[i], expected.rgb[i], relative * double(expected.rgb[i]) + 1e-4)
                    << "n=" << n << " at " << i / 3 % 48 << ' ' << i / 144;
            EXPECT_EQ(found.counters.visible, expected.counters.visible);
            EXPECT_EQ(found.counters.once, expected.counters.once);
            EXPECT_EQ(found.counters.shadedPixels, expected.counters.shadedPixels);
            EXPECT_EQ(found.counters.shadingEvents, found.counters.shadedPixels) << "one event per pixel";
            EXPECT_EQ(found.counters.maxEventsPerPixel, 1u);
        }
    }
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(VisibilityCases);

// Each surface fills pixels beside those at its edge, so that each sample finds an event of its own surface.
TYPED_TEST_P(VisibilityCases, EdgesHaveTheLightOfBothSides) {
    std::vector<Triangle> list = rectangle(-10, -10, 58, 42, 8, matte({0.8f, 0.4f, 0.1f}));
    Triangle slanted;
    slanted.position[0] = {3.3f, 4.1f, -3};
    slanted.position[1] = {44.2f, 9.7f, -3};
    slanted.position[2] = {17.9f, 29.6f, -3};
    slanted.material = matte({0.1f, 0.7f, 0.3f}, {0.6f, 0, 0.8f});
    list.push_back(slanted);
    this->expectSupersampled(list, 0.01);
}

// One plane with two colours is one surface: light moves to the reflectance of each sample.
TYPED_TEST_P(VisibilityCases, ColoursOfOnePlaneStay) {
    std::vector<Triangle> list = rectangle(-10, -10, 20.4f, 42, 5, matte({0.9f, 0.5f, 0.2f}));
    for (const Triangle& t : rectangle(20.4f, -10, 58, 42, 5, matte({0.2f, 0.6f, 0.4f})))
        list.push_back(t);
    this->expectSupersampled(list, 0.02);
}

// Emission belongs to the sample, not to the event.
TYPED_TEST_P(VisibilityCases, EmissionStaysWhereItIs) {
    std::vector<Triangle> list = rectangle(-10, -10, 30.3f, 42, 5, matte({0.5f, 0.5f, 0.5f}));
    Material lamp = matte({0.5f, 0.5f, 0.5f});
    lamp.emissive = {3, 0.5f, 0, 0};
    for (const Triangle& t : rectangle(30.3f, -10, 58, 42, 5, lamp))
        list.push_back(t);
    this->expectSupersampled(list, 0.01);
}

// A hair of a third of a pixel is no pixel's event beyond some rows. It takes the most similar light, and nothing else
// changes.
TYPED_TEST_P(VisibilityCases, ThinSurfacesTakeSimilarLight) {
    std::vector<Triangle> list = rectangle(-10, -10, 58, 42, 8, matte({0.5f, 0.5f, 0.5f}));
    for (const Triangle& t : rectangle(20.1f, -10, 20.4f, 42, 3, matte({0.25f, 0.25f, 0.25f}, {0.1f, 0, 1})))
        list.push_back(t);
    const Shot shot{.triangles = list};
    const std::vector<float> expected = show(this->context, visibilitySettings("ssaa", 8), shot).rgb;
    const std::vector<float> found = show(this->context, visibilitySettings("visibility", 8), shot).rgb;
    for (size_t i = 0; i < found.size(); ++i)
        ASSERT_NEAR(found[i], expected[i], 0.02 * double(expected[i])) << i / 3 % 48;
}

// Pixels without geometry, partly covered ones, and sizes that are no multiple of a tile.
TYPED_TEST_P(VisibilityCases, OddSizesOverTheBackground) {
    for (const glm::uvec2 size : {glm::uvec2(1, 1), {3, 17}, {33, 9}}) {
        ViewSettings settings = visibilitySettings("visibility", 8);
        settings.width = size.x;
        settings.height = size.y;
        settings.projection = pixelOrthographic(float(size.x), float(size.y), 10);
        const Shot shot{.triangles = rectangle(0.3f, 0.3f, 0.7f * float(size.x), 0.8f * float(size.y), 5,
                                               matte({0.5f, 0.5f, 0.5f}))};
        const std::vector<float> found = show(this->context, settings, shot).rgb;
        settings.config.technique = "ssaa";
        const std::vector<float> expected = show(this->context, settings, shot).rgb;
        EXPECT_EQ(nonFinite(found), 0u);
        for (size_t i = 0; i < found.size(); ++i)
            ASSERT_NEAR(found[i], expected[i], 1e-3) << size.x << 'x' << size.y << " at " << i;
    }
}

REGISTER_TYPED_TEST_SUITE_P(VisibilityCases, EdgesHaveTheLightOfBothSides, ColoursOfOnePlaneStay,
                            EmissionStaysWhereItIs, ThinSurfacesTakeSimilarLight, OddSizesOverTheBackground);

} // namespace agaa::test
