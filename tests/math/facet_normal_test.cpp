// Facet normals of depth planes against the normals of the planes in view space.
#include "shader_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

namespace {

struct View {
    glm::dvec2 size, scale, offset;
    double p22 = 0, p32 = 0;
    bool isOrthographic = false;
};

glm::dvec2 ndcOf(const View& view, const glm::dvec3& p) {
    return view.isOrthographic ? view.scale * glm::dvec2(p) + view.offset
                               : (view.scale * glm::dvec2(p) + view.offset * p.z) / -p.z;
}
double depthOf(const View& view, const glm::dvec3& p) {
    return view.isOrthographic ? view.p22 * p.z + view.p32 : (view.p22 * p.z + view.p32) / -p.z;
}

struct Plane {
    glm::dvec3 normal;
    glm::dvec3 stored; // depth at the centre of the pixel, and its change per pixel
    glm::dvec2 ndc;    // centre of the pixel
};

// Returns where the ray of an image point meets the plane.
glm::dvec3 pointAt(const View& view, const glm::dvec3& through, const glm::dvec3& normal, glm::dvec2 ndc) {
    const glm::dvec2 xy = (view.isOrthographic ? ndc - view.offset : ndc + view.offset) / view.scale;
    const glm::dvec3 from = view.isOrthographic ? glm::dvec3(xy, 0) : glm::dvec3(0);
    const glm::dvec3 along = view.isOrthographic ? glm::dvec3(0, 0, -1) : glm::dvec3(xy, -1);
    return from + along * (glm::dot(through - from, normal) / glm::dot(along, normal));
}

Plane planeOf(const View& view, const glm::dvec3& through, const glm::dvec3& normal) {
    Plane plane{normal, {}, ndcOf(view, through)};
    const glm::dvec2 pixel = 2.0 / view.size;
    const double step = 1e-4;
    const auto depthAt = [&](double x, double y) {
        return depthOf(view, pointAt(view, through, normal, plane.ndc + pixel * glm::dvec2(x, y)));
    };
    plane.stored = {depthAt(0, 0), (depthAt(step, 0) - depthAt(-step, 0)) / (2 * step),
                    (depthAt(0, step) - depthAt(0, -step)) / (2 * step)};
    return plane;
}

TEST(FacetNormal, IsThatOfThePlane) {
    std::mt19937 random(4);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    double largest = 0, largestDouble = 0;
    for (int i = 0; i < 100000; ++i) {
        View view;
        view.size = {uniform(1, 4096), uniform(1, 4096)};
        view.scale = {uniform(0.5, 3), uniform(0.5, 3)};
        view.offset = {uniform(-0.5, 0.5), uniform(-0.5, 0.5)};
        view.isOrthographic = i % 3 == 0;
        const bool isReversed = i % 2 == 0;
        const double nearest = std::pow(10, uniform(-3, 1)), far = nearest * std::pow(10, uniform(0.3, 3));
        view.p22 = view.isOrthographic ? -1 / (far - nearest) : -far / (far - nearest);
        view.p32 = view.isOrthographic ? -nearest / (far - nearest) : -far * nearest / (far - nearest);
        if (isReversed) { // depth becomes 1 - depth
            view.p22 = view.isOrthographic ? -view.p22 : -1 - view.p22;
            view.p32 = view.isOrthographic ? 1 - view.p32 : -view.p32;
        }
        // Standard depth and depths of a parallel projection are too coarse for float far from the eye.
        const double distance =
            uniform(nearest, isReversed && !view.isOrthographic ? far : std::min(far, 30 * nearest));
        const glm::dvec3 through(uniform(-1, 1) * distance, uniform(-1, 1) * distance, -distance);
        const glm::dvec3 toEye = view.isOrthographic ? glm::dvec3(0, 0, 1) : -glm::normalize(through);
        glm::dvec3 normal = glm::normalize(glm::dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
        if (std::fabs(glm::dot(normal, toEye)) < 0.02)
            continue; // within a degree of edge-on
        normal *= glm::dot(normal, toEye) < 0 ? -1.0 : 1.0;
        const Plane plane = planeOf(view, through, normal);
        const double sign = isReversed ? -1 : 1;
        const auto d =
            math_d::agaa_facetNormal(math_d::agaa_facetFrame(plane.ndc, view.size * 0.5, view.scale, view.offset,
                                                             view.p22, view.isOrthographic, sign),
                                     plane.stored * sign);
        const auto f = math_f::agaa_facetNormal(
            math_f::agaa_facetFrame(glm::vec2(plane.ndc), glm::vec2(view.size * 0.5), glm::vec2(view.scale),
                                    glm::vec2(view.offset), float(view.p22), view.isOrthographic, float(sign)),
            glm::vec3(plane.stored * sign));
        // The normal is up to its sign, which planes of one pixel share.
        const double side = glm::dot(glm::dvec3(d), normal) < 0 ? -1 : 1;
        largestDouble = std::max(largestDouble, glm::length(glm::dvec3(d) * side - normal));
        largest = std::max(largest, glm::length(glm::dvec3(f) * side - normal));
    }
    std::printf("largest error %.2g in double, %.2g in float\n", largestDouble, largest);
    EXPECT_LT(largestDouble, 1e-4) << "central differences";
    EXPECT_LT(largest, 1e-3);
}

// Planes of one pixel that face the eye have normals on one side.
TEST(FacetNormal, SharesItsSideInAPixel) {
    const auto frame = math_f::agaa_facetFrame({0.3f, -0.2f}, {32, 16}, {1.2f, 1.8f}, {0.1f, 0}, 0, 0, -1);
    const glm::vec3 level = math_f::agaa_facetNormal(frame, {-0.1f, 0, 0});
    EXPECT_GT(glm::dot(math_f::agaa_facetNormal(frame, {-0.2f, 0.001f, 0}), level), 0.9f);
    EXPECT_NEAR(glm::length(level), 1, 1e-6f);
}

TEST(FacetNormal, IsFiniteForExtremePlanes) {
    std::mt19937 random(5);
    const float values[] = {0, -0.0f, 1e-38f, -1e-38f, 1, -1, 4096, -4096, 1e30f, -1e30f};
    const auto any = [&] { return values[random() % std::size(values)]; };
    for (int i = 0; i < 100000; ++i) {
        const auto frame = math_f::agaa_facetFrame({any(), any()}, {4096, 1}, {any(), any()}, {any(), any()}, any(),
                                                   uint32_t(i % 2), i % 3 ? 1.0f : -1.0f);
        const glm::vec3 n = math_f::agaa_facetNormal(frame, {any() / 1e27f, any() / 1e27f, any() / 1e27f});
        for (int k = 0; k < 3; ++k)
            ASSERT_TRUE(std::isfinite(n[k])) << i;
    }
}

} // namespace
