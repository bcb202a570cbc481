// The filter of edges "smaa" on edges of known coverage. Each graphics API instantiates these.
#pragma once

#include "shown.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace agaa::test {

inline double displayed(double linear) { return std::pow(linear / (1 + linear), 1 / 2.2); }

// The share of the bright side in a pixel of an edge between light of 0.1 and 1, as displayed.
inline double shownShare(float light) {
    return (displayed(double(light)) - displayed(0.1)) / (displayed(1) - displayed(0.1));
}

// Coverage of the pixel, by points.
inline double sideShare(float slope, bool isTransposed, double x, double y) {
    if (isTransposed)
        std::swap(x, y);
    int inside = 0;
    for (int i = 0; i < 256; ++i)
        inside += y + (i / 16 + 0.5) / 16 > 16.3 + double(slope) * (x + (i % 16 + 0.5) / 16 - 24.2);
    return inside / 256.0;
}

inline ViewSettings filterSettings(const char* technique, glm::uvec2 size = {48, 32}) {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.facts.shadowMapCount = 0;
    settings.width = size.x;
    settings.height = size.y;
    settings.projection = pixelOrthographic(float(size.x), float(size.y), 10);
    return settings;
}

inline Material evenLight(float light) {
    Material material;
    material.emissive = glm::vec4(glm::vec3(light), 0);
    return material;
}

// A bright triangle below the line through (x0, y0) with this slope, over a dark wall.
inline std::vector<Triangle> slopedEdge(float slope, bool isTransposed) {
    std::vector<Triangle> list = rectangle(-10, -10, 200, 200, 8, evenLight(0.1f));
    Triangle t;
    t.position[0] = {-10, 16.3f - 34.2f * slope, -3};
    t.position[1] = {58, 16.3f + 33.8f * slope, -3};
    t.position[2] = {24, 1000, -3};
    if (isTransposed)
        for (glm::vec3& corner : t.position)
            std::swap(corner.x, corner.y);
    t.material = evenLight(1);
    list.push_back(t);
    return list;
}

// Root of the mean squared error of coverage over pixels at the edge, away from the border of the image.
inline double coverageError(const std::vector<float>& rgb, float slope, bool isTransposed) {
    double sum = 0;
    int pixels = 0;
    for (int y = 6; y < 26; ++y)
        for (int x = 6; x < 42; ++x) {
            const double truth = sideShare(slope, isTransposed, x, y);
            const double error = shownShare(rgb[3 * size_t(y * 48 + x)]) - truth;
            if (truth > 0 && truth < 1) {
                sum += error * error;
                ++pixels;
            } else {
                EXPECT_LT(std::abs(error), 0.26) << slope << " at " << x << ' ' << y;
            }
        }
    return std::sqrt(sum / pixels);
}

template <class Host> class FilterCases : public testing::Test {
protected:
    double errorOf(const char* technique, float slope, bool isTransposed) {
        return coverageError(
            show(context, filterSettings(technique), {.triangles = slopedEdge(slope, isTransposed), .lights = {}}).rgb,
            slope, isTransposed);
    }
    typename Host::Context context;
};
TYPED_TEST_SUITE_P(FilterCases);

// The edge of a half-plane: a pixel's share is its coverage. SMAA follows edges and diagonals of all slopes.
TYPED_TEST_P(FilterCases, SlopedEdgesHaveTheirCoverage) {
    for (const bool isTransposed : {false, true})
        for (const float slope : {0.06f, 0.45f, 0.93f, -0.1f, -1.0f}) {
            const double single = this->errorOf("single", slope, isTransposed);
            const double smaa = this->errorOf("smaa", slope, isTransposed);
            std::printf("slope %5.2f%s: error of coverage: single %.3f, smaa %.3f\n", double(slope),
                        isTransposed ? " transposed" : "", single, smaa);
            EXPECT_LT(smaa, 0.1) << slope;
            EXPECT_LT(smaa, 0.4 * single) << slope;
        }
}

// Edges along rows and columns have no steps to soften.
TYPED_TEST_P(FilterCases, StraightEdgesStay) {
    std::vector<Triangle> list = rectangle(-10, -10, 58, 42, 8, evenLight(0.1f));
    for (const Triangle& t : rectangle(20, -10, 58, 42, 3, evenLight(1)))
        list.push_back(t);
    const std::vector<float> expected =
        show(this->context, filterSettings("single"), {.triangles = list, .lights = {}}).rgb;
    const std::vector<float> found = show(this->context, filterSettings("smaa"), {.triangles = list, .lights = {}}).rgb;
    for (size_t i = 0; i < found.size(); ++i)
        ASSERT_NEAR(found[i], expected[i], 1e-3f) << i;
}

// Corners of a square keep most of their contrast.
TYPED_TEST_P(FilterCases, CornersStaySharp) {
    std::vector<Triangle> list = rectangle(-10, -10, 58, 42, 8, evenLight(0.1f));
    for (const Triangle& t : rectangle(10, 10, 26, 26, 3, evenLight(1)))
        list.push_back(t);
    const Shown shown = show(this->context, filterSettings("smaa"), {.triangles = list, .lights = {}});
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 48; ++x) {
            const double truth = x >= 10 && x < 26 && y >= 10 && y < 26;
            EXPECT_NEAR(shownShare(shown.rgb[3 * size_t(y * 48 + x)]), truth, 0.13) << x << ' ' << y;
        }
}

// Sizes that are no multiple of a tile or of a region, and images smaller than either.
TYPED_TEST_P(FilterCases, OddSizes) {
    for (const glm::uvec2 size : {glm::uvec2(1, 1), {3, 65}, {33, 31}, {97, 2}}) {
        const std::vector<float> found =
            show(this->context, filterSettings("smaa", size), {.triangles = slopedEdge(0.3f, false), .lights = {}}).rgb;
        EXPECT_EQ(nonFinite(found), 0u);
        for (const float value : found) {
            EXPECT_GE(value, 0.0999f);
            EXPECT_LE(value, 1.001f);
        }
    }
}

REGISTER_TYPED_TEST_SUITE_P(FilterCases, SlopedEdgesHaveTheirCoverage, StraightEdgesStay, CornersStaySharp, OddSizes);

} // namespace agaa::test
