// Shares of pixels beyond edges: against the areas of the lines that make the edges, and in float against double.
#include "shader_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using math_d::agaa_crossesAcross;
using math_d::agaa_crossesHere;

// The area of a pixel's column between the boundary and a line through (0, from) and (length, to), by sampling.
glm::dvec2 sampledAreas(double from, double to, double length, double column) {
    glm::dvec2 areas(0);
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        const double height = from + (to - from) * (column + (i + 0.5) / steps) / length;
        areas += glm::dvec2(std::max(-height, 0.0), std::max(height, 0.0)) / double(steps);
    }
    return areas;
}

TEST(EdgeShares, LinesThroughTheEdge) {
    for (int length = 1; length <= 12; ++length)
        for (int before = 0; before < length; ++before) {
            const glm::dvec2 found =
                math_d::agaa_edgeShares(before, length - 1 - before, agaa_crossesHere, agaa_crossesAcross, 0);
            const glm::dvec2 expected = sampledAreas(-0.5, 0.5, length, before);
            EXPECT_NEAR(found.x, expected.x, 1e-6) << length << ' ' << before;
            EXPECT_NEAR(found.y, expected.y, 1e-6) << length << ' ' << before;
        }
}

// A line crosses the centres of other rows where the image is moved. The shares are those of the line itself.
TEST(EdgeShares, FollowTheLineOfAMovedImage) {
    for (const double moved : {-0.25, 0.25, 0.4})
        for (int length = 2; length <= 12; ++length)
            for (int before = 0; before < length; ++before) {
                const glm::dvec2 found =
                    math_d::agaa_edgeShares(before, length - 1 - before, agaa_crossesHere, agaa_crossesAcross, moved);
                const glm::dvec2 expected = sampledAreas(-0.5 + moved, 0.5 + moved, length, before);
                EXPECT_NEAR(found.x, expected.x, 1e-6) << moved << ' ' << length << ' ' << before;
                EXPECT_NEAR(found.y, expected.y, 1e-6) << moved << ' ' << length << ' ' << before;
            }
    EXPECT_EQ(math_d::agaa_edgeShares(2, 3, 0u, 0u, 0.25), glm::dvec2(0));
}

// An end without a crossing edge, and two ends that cross to one side: lines end on the boundary in the middle.
TEST(EdgeShares, LinesThatEndInTheMiddleFollowAMovedImage) {
    for (const double moved : {-0.4, 0.0, 0.25, 1.0})
        for (int length = 1; length <= 9; ++length)
            for (int before = 0; before < length; ++before) {
                const auto shares = [&](uint32_t first, uint32_t last) {
                    return math_d::agaa_edgeShares(before, length - 1 - before, first, last, moved);
                };
                const auto areasOfEnds = [&](double from, double to) {
                    glm::dvec2 areas(0);
                    constexpr int steps = 20000;
                    for (int i = 0; i < steps; ++i) {
                        const double at = 2 * (before + (i + 0.5) / steps) / length - 1; // -1, 1: the ends
                        const double height = at < 0 ? -at * from : at * to;
                        areas += glm::dvec2(std::max(-height, 0.0), std::max(height, 0.0)) / double(steps);
                    }
                    return areas;
                };
                const auto expectNear = [&](glm::dvec2 found, glm::dvec2 expected) {
                    EXPECT_NEAR(found.x, expected.x, 1e-6) << moved << ' ' << length << ' ' << before;
                    EXPECT_NEAR(found.y, expected.y, 1e-6) << moved << ' ' << length << ' ' << before;
                };
                expectNear(shares(agaa_crossesAcross, 0u), areasOfEnds(0.5 + moved, 0));
                expectNear(shares(0u, agaa_crossesHere), areasOfEnds(0, -0.5 + moved));
                expectNear(shares(agaa_crossesHere, agaa_crossesHere), areasOfEnds(-0.5 + moved, -0.5 + moved));
                expectNear(shares(agaa_crossesAcross, agaa_crossesAcross), areasOfEnds(0.5 + moved, 0.5 + moved));
            }
}

TEST(EdgeShares, EndsWithoutACrossingEdgeStayOnTheBoundary) {
    for (int length = 1; length <= 9; ++length) {
        double sum = 0;
        for (int before = 0; before < length; ++before) {
            EXPECT_EQ(math_d::agaa_edgeShares(before, length - 1 - before, 0u, 0u, 0), glm::dvec2(0));
            const glm::dvec2 corner = math_d::agaa_edgeShares(before, length - 1 - before, agaa_crossesAcross, 0u, 0);
            EXPECT_EQ(corner.x, 0);
            sum += corner.y;
        }
        // A triangle of half the length and half a pixel.
        EXPECT_NEAR(sum, 0.125 * length, 1e-12) << length;
    }
}

// An edge and its mirror image have the same shares.
TEST(EdgeShares, AreSymmetric) {
    for (const double moved : {-1.0, 0.0, 0.25, 0.75})
        for (uint32_t first = 0; first < 4; ++first)
            for (uint32_t last = 0; last < 4; ++last)
                for (int before = 0; before < 7; ++before)
                    for (int after = 0; after < 7; ++after) {
                        const glm::dvec2 a = math_d::agaa_edgeShares(before, after, first, last, moved);
                        const glm::dvec2 b = math_d::agaa_edgeShares(after, before, last, first, moved);
                        EXPECT_NEAR(a.x, b.x, 1e-12);
                        EXPECT_NEAR(a.y, b.y, 1e-12);
                        EXPECT_LE(std::max(a.x, a.y), 0.5 + std::abs(moved));
                        EXPECT_GE(std::min(a.x, a.y), 0.0);
                        const auto f = math_f::agaa_edgeShares(float(before), float(after), first, last, float(moved));
                        EXPECT_NEAR(double(f.x), a.x, 5e-7);
                        EXPECT_NEAR(double(f.y), a.y, 5e-7);
                    }
}

// A corner whose sides are long keeps a quarter of its blur, at the nearer end.
TEST(EdgeShares, CornersOfShapesStay) {
    EXPECT_EQ(math_d::agaa_cornerShares(0, 5, agaa_crossesHere, 0u), glm::dvec2(0.25, 1));
    EXPECT_EQ(math_d::agaa_cornerShares(5, 0, agaa_crossesHere, 0u), glm::dvec2(1, 1));
    EXPECT_EQ(math_d::agaa_cornerShares(2, 2, agaa_crossesHere, agaa_crossesHere), glm::dvec2(0.25, 1));
    EXPECT_EQ(math_d::agaa_cornerShares(5, 0, agaa_crossesHere, agaa_crossesAcross), glm::dvec2(1, 0.25));
}

TEST(EdgeShares, DiagonalLinesCutAnEighth) {
    for (uint32_t down = 3; down < 8; ++down)
        for (uint32_t up = 3; up < 8; ++up) {
            const glm::dvec2 shares =
                math_d::agaa_diagonalShares(math_d::agaa_lowerEnd(down, false), math_d::agaa_upperEnd(up, false));
            EXPECT_NEAR(shares.x, 0.125, 1e-12);
            EXPECT_NEAR(shares.y, 0.125, 1e-12);
        }
}

// The share above a line, against a count of points.
TEST(EdgeShares, ShareAboveALine) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> at(-3, 4);
    double error = 0;
    for (int i = 0; i < 300; ++i) {
        const glm::dvec2 from(-std::abs(at(random)) - 0.1, at(random)), to(1.1 + std::abs(at(random)), at(random));
        int above = 0;
        constexpr int side = 200;
        for (int k = 0; k < side * side; ++k) {
            const double x = (k % side + 0.5) / side, y = (k / side + 0.5) / side;
            above += y < from.y + (to.y - from.y) * (x - from.x) / (to.x - from.x);
        }
        EXPECT_NEAR(math_d::agaa_shareAbove(from, to), double(above) / (side * side), 0.006);
        const float single = math_f::agaa_shareAbove(glm::vec2(from), glm::vec2(to));
        error = std::max(error, std::abs(double(single) - math_d::agaa_shareAbove(from, to)));
    }
    EXPECT_LT(error, 2e-6);
    // Lines along rows have no range to divide by.
    EXPECT_EQ(math_f::agaa_shareAbove(glm::vec2(-1, 0.25f), glm::vec2(2, 0.25f)), 0.25f);
    EXPECT_EQ(math_f::agaa_meanOfClamped(0.0f, 0.0f), 0.0f);
}

} // namespace
