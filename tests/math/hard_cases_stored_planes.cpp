// Hard case 61 of docs/numerics.md: the depth planes that surfaces and fragments keep (stored_plane.glsl).
#include "coverage_oracle.h"
#include "hard_case_figures.h"

using namespace test_math;

namespace {

using math_f::agaa_DepthPlane;

struct Triangle {
    glm::dvec2 at[3]; // from the pixel's centre, in pixels
    double depth[3];

    double depthAt(const glm::dvec2& p) const {
        const auto area = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
        const double whole = area(at[1] - at[0], at[2] - at[0]);
        const double v = area(p - at[0], at[2] - at[0]) / whole, w = area(at[1] - at[0], p - at[0]) / whole;
        return depth[0] + (depth[1] - depth[0]) * v + (depth[2] - depth[0]) * w;
    }
    double extent() const {
        return std::max({depth[0], depth[1], depth[2]}) - std::min({depth[0], depth[1], depth[2]});
    }
    agaa_DepthPlane plane() const {
        const auto vertex = [](const glm::dvec2& p) { return glm::vec3(p + 0.5, 1); };
        return math_f::agaa_depthPlane(vertex(at[0]), vertex(at[1]), vertex(at[2]),
                                       glm::vec3(depth[0], depth[1], depth[2]), glm::vec2(0.5f));
    }
};

// The plane without a range, flattened around the middle of its depths until it stays among them in the whole pixel.
double flattenedDepthAt(const agaa_DepthPlane& plane, const glm::dvec2& p) {
    const float reach = (std::fabs(plane.slope.x) + std::fabs(plane.slope.y)) * 0.5f;
    const float half = (plane.range.y - plane.range.x) * 0.5f;
    const float kept = reach > half ? half / reach : 1.0f;
    return double(plane.range.x + half) + glm::dot(glm::dvec2(plane.slope * kept), p);
}

// The plane as a surface keeps it, with the samples that it covers.
agaa_DepthPlane surfacePlane(const agaa_DepthPlane& plane, const glm::vec2& anchor) {
    return math_f::agaa_loadedPlane(math_f::agaa_storePlane({plane.depth, plane.slope.x, plane.slope.y},
                                                            math_f::agaa_depthsOfRange(plane.range), anchor),
                                    anchor, false);
}

agaa_DepthPlane fragmentPlane(agaa_DepthPlane plane) {
    plane.range = math_f::agaa_unpackRange(plane.depth, plane.slope, math_f::agaa_packRange(plane));
    return plane;
}

// Errors in units of the depths of triangles.
struct Errors {
    double sum = 0, most = 0;
    void add(double error) {
        sum += error;
        most = std::max(most, error);
    }
};

// A triangle of a fraction of a pixel leaves its depths within the pixel. Its samples have their own depths
// nevertheless.
TEST(HardCase61_SmallTriangles, KeepTheirDepths) {
    Random random(61);
    // Triangles narrower than 1/1024 of a pixel are flattened (agaa_steepestSlope()).
    HardCaseFigures figures(61, "error of the depth at a sample, in units of the triangle's range of depths", 0.15);
    Errors flattened, surface, fragment;
    std::size_t count = 0;
    for (int i = 0; i < 400000; ++i) {
        Triangle t;
        const double size = random.decades(0.05, 0.5), depth = random.range(0.1, 0.8),
                     extent = random.decades(1e-3, 0.1);
        const glm::dvec2 middle(random.range(-0.4, 0.4), random.range(-0.4, 0.4));
        for (int k = 0; k < 3; ++k) {
            t.at[k] = middle + size * glm::dvec2(random.range(-1, 1), random.range(-1, 1));
            t.depth[k] = depth + extent * random.range(0, 1);
        }
        const auto vertex = [](const glm::dvec2& p) { return glm::vec3(p + 0.5, 1); };
        const glm::uvec4 mask =
            math_f::agaa_triangleCoverage(vertex(t.at[0]), vertex(t.at[1]), vertex(t.at[2]), glm::vec2(0.5f), 64);
        if (math_f::agaa_coverageCount(mask) == 0 || t.extent() < 0.1 * extent)
            continue;
        const agaa_DepthPlane plane = t.plane();
        const agaa_DepthPlane kept[] = {surfacePlane(plane, math_f::agaa_coverageMiddle(mask, 64)),
                                        fragmentPlane(plane)};
        for (unsigned s = 0; s < 64; ++s) {
            if (!math_f::agaa_isCovered(mask, s))
                continue;
            const glm::vec2 at = math_f::agaa_coveragePosition(s, 64);
            const double truth = t.depthAt(glm::dvec2(at));
            flattened.add(std::abs(flattenedDepthAt(plane, glm::dvec2(at)) - truth) / t.extent());
            surface.add(std::abs(double(math_f::agaa_depthAt(kept[0], at)) - truth) / t.extent());
            fragment.add(std::abs(double(math_f::agaa_depthAt(kept[1], at)) - truth) / t.extent());
            figures.naive(std::abs(flattenedDepthAt(plane, glm::dvec2(at)) - truth) / t.extent());
            figures.ours(std::max(std::abs(double(math_f::agaa_depthAt(kept[0], at)) - truth),
                                  std::abs(double(math_f::agaa_depthAt(kept[1], at)) - truth)) /
                         t.extent());
            ++count;
        }
    }
    std::printf("[ measured ] %zu samples; error of depths in units of a triangle's: flattened %.3g (at most %.3g), "
                "surfaces %.3g (%.3g), fragments %.3g (%.3g)\n",
                count, flattened.sum / double(count), flattened.most, surface.sum / double(count), surface.most,
                fragment.sum / double(count), fragment.most);
    EXPECT_GT(count, 100000u);
    EXPECT_GT(flattened.sum / double(count), 0.1) << "a plane without a range";
    EXPECT_GT(flattened.most, 0.5);
    EXPECT_LT(surface.sum / double(count), 0.001) << "rounded slopes and ends of the range";
    EXPECT_LT(fragment.sum / double(count), 5e-5);
    EXPECT_LT(fragment.most, 0.15);
}

// A triangle between 0.3 and 0.5 right of the centre, of depth 0.1 x, is in front of a surface at 0.04 at its left end.
TEST(HardCase61_SmallTriangles, AreInFrontOfWhatIsBehind) {
    const Triangle t = {{{0.3, -0.4}, {0.5, 0}, {0.3, 0.4}}, {0.03, 0.05, 0.03}};
    const agaa_DepthPlane plane = t.plane();
    const glm::vec2 left(0.3f, 0), centroid(0.37f, 0);
    EXPECT_NEAR(flattenedDepthAt(plane, glm::dvec2(left)), 0.046, 1e-6);
    EXPECT_NEAR(double(math_f::agaa_depthAt(surfacePlane(plane, centroid), left)), 0.03, 1e-3);
    EXPECT_NEAR(double(math_f::agaa_depthAt(fragmentPlane(plane), left)), 0.03, 1e-6);
}

// Surfaces that are loaded and stored again are the same words, so that lists and ordered fragments agree.
TEST(StoredPlane, StoringAgainChangesNothing) {
    Random random(62);
    for (int i = 0; i < 300000; ++i) {
        const auto slope = [&] {
            return float(random.below(8) ? random.decades(1e-18, 2000) * (random.below(2) ? 1 : -1) : 0.0);
        };
        const glm::vec3 plane(random.range(-1, 1), slope(), slope());
        const glm::vec2 anchor(random.range(-0.5, 0.5), random.range(-0.5, 0.5));
        const auto side = [&] { return float(random.below(8) ? random.decades(1e-9, 1) : 0.0); };
        const glm::vec3 depths(random.range(0, 1), side(), side());
        const auto once = math_f::agaa_storePlane(plane, depths, anchor);
        const auto again =
            math_f::agaa_storePlane(math_f::agaa_storedPlane(once), math_f::agaa_storedDepths(once, anchor), anchor);
        ASSERT_EQ(once.depth, again.depth) << i;
        ASSERT_EQ(once.slopes, again.slopes) << i;
        const glm::vec3 loaded = math_f::agaa_storedDepths(once, anchor);
        ASSERT_TRUE(math_f::agaa_isFinite3(loaded) && loaded.y >= 0 && loaded.z >= 0);
        const glm::vec3 kept = math_f::agaa_storedPlane(once);
        const float largest = std::max(std::fabs(plane.y), std::fabs(plane.z));
        ASSERT_LE(std::fabs(kept.y - plane.y), largest / 126 + 5e-16f) << i;
        ASSERT_LE(std::fabs(kept.z - plane.z), largest / 126 + 5e-16f) << i;
    }
}

// Sides of surfaces are at most a quarter of an octave off; ranges of fragments hold the whole range.
TEST(StoredPlane, RangesAreNearTheirs) {
    Random random(63);
    for (int i = 0; i < 300000; ++i) {
        const glm::vec2 slope(random.decades(1e-6, 10), -random.decades(1e-6, 10));
        const float whole = std::fabs(slope.x) + std::fabs(slope.y);
        const float side = whole * float(random.decades(1e-4, 1));
        const float kept = math_f::agaa_unpackSide(math_f::agaa_packSide(side, whole), whole);
        ASSERT_GE(kept, side * 0.84f);
        ASSERT_LE(kept, side * 1.19f);
        agaa_DepthPlane plane{float(random.range(-1, 1)), slope, {}};
        plane.range.x = plane.depth + whole * float(random.range(-0.5, 0.5));
        plane.range.y = std::min(plane.range.x + whole * float(random.range(0, 1)), plane.depth + 0.5f * whole);
        const agaa_DepthPlane loaded = fragmentPlane(plane);
        const float step = whole * 2e-5f + std::fabs(plane.depth) * 1e-6f;
        const float rounding = (whole + std::fabs(plane.depth)) * 2.4e-7f;
        ASSERT_LE(loaded.range.x, plane.range.x + rounding);
        ASSERT_GE(loaded.range.x, plane.range.x - step);
        ASSERT_GE(loaded.range.y, plane.range.y - rounding);
        ASSERT_LE(loaded.range.y, plane.range.y + step);
    }
}

} // namespace
