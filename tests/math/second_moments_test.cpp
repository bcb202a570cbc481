// Second moments of positions, relative to one of them as passes sum them, in float against double.
#include "test_support.h"

using namespace test_math;

namespace {

// Sums around the first position, then moments around the mean.
math_f::agaa_SecondMoments inFloat(const std::vector<glm::vec3>& positions) {
    math_f::agaa_SecondMoments sums{glm::vec3(0), glm::vec3(0)};
    glm::vec3 mean(0);
    for (const glm::vec3& p : positions) {
        const glm::vec3 away = p - positions.front();
        math_f::agaa_addSecondMoments(sums, 1.0f, away);
        mean += away;
    }
    const auto count = float(positions.size());
    return math_f::agaa_momentsAroundMean(sums, count, mean / count);
}

// Two passes over the positions.
math_d::agaa_SecondMoments exact(const std::vector<glm::vec3>& positions) {
    glm::dvec3 mean(0);
    for (const glm::vec3& p : positions)
        mean += glm::dvec3(p) / double(positions.size());
    math_d::agaa_SecondMoments m{glm::dvec3(0), glm::dvec3(0)};
    for (const glm::vec3& p : positions)
        math_d::agaa_addSecondMoments(m, 1.0 / double(positions.size()), glm::dvec3(p) - mean);
    return m;
}

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// The samples of a pixel far away: their distances are small beside their distance from the eye.
std::vector<glm::vec3> someSamples(Random& random) {
    const glm::dvec3 middle = random.direction() * random.decades(1e-3, 1e5);
    const double width = glm::length(middle) * random.decades(1e-4, 1e-1);
    std::vector<glm::vec3> positions(1 + random.below(32));
    for (glm::vec3& p : positions) {
        const double distance = width * random.unit();
        p = glm::vec3(middle + random.direction() * distance);
    }
    return positions;
}

TEST(SecondMoments, OfPositionsInFloatAreThoseOfTwoPassesInDouble) {
    Random random(811);
    Worst error("moments around the mean, relative to the largest", 5e-6);
    for (int k = 0; k < 20'000; ++k) {
        const std::vector<glm::vec3> positions = someSamples(random);
        const math_f::agaa_SecondMoments m = inFloat(positions);
        const math_d::agaa_SecondMoments truth = exact(positions);
        EXPECT_GE(std::min({m.squares.x, m.squares.y, m.squares.z}), 0);
        const double scale = std::max(largest(truth.squares), 1e-30);
        error.add(largest(glm::dvec3(m.squares) - truth.squares) / scale);
        error.add(largest(glm::dvec3(m.mixed) - truth.mixed) / scale);
        if (positions.size() == 1) {
            EXPECT_EQ(m.squares, glm::vec3(0));
            EXPECT_EQ(m.mixed, glm::vec3(0));
        }
    }
}

// A rotation keeps the trace, and the moment in a direction is that in the same direction of the other basis.
TEST(SecondMoments, InAnotherBasisAreThoseOfRotatedVectors) {
    Random random(812);
    Worst error("moments of rotated vectors, relative to the largest", 2e-6);
    for (int k = 0; k < 5'000; ++k) {
        const glm::dvec3 a = random.direction();
        const glm::dvec3 b = glm::normalize(glm::cross(a, random.direction()));
        const glm::dvec3 c = glm::cross(a, b);
        math_f::agaa_SecondMoments m{glm::vec3(0), glm::vec3(0)};
        math_d::agaa_SecondMoments rotated{glm::dvec3(0), glm::dvec3(0)};
        const double size = random.decades(1e-6, 1e6);
        for (unsigned i = 1 + random.below(32); i > 0; --i) {
            const glm::dvec3 v = random.direction() * size;
            math_f::agaa_addSecondMoments(m, 0.25f, glm::vec3(v));
            math_d::agaa_addSecondMoments(rotated, 0.25, glm::dvec3(glm::dot(v, a), glm::dot(v, b), glm::dot(v, c)));
        }
        const math_f::agaa_SecondMoments turned =
            math_f::agaa_momentsInBasis(m, glm::vec3(a), glm::vec3(b), glm::vec3(c));
        error.add(largest(glm::dvec3(turned.squares) - rotated.squares) / largest(rotated.squares));
        error.add(largest(glm::dvec3(turned.mixed) - rotated.mixed) / largest(rotated.squares));
    }
}

// The direction of the longest axis has at least nine tenths of the largest moment, which random directions estimate.
TEST(SecondMoments, LongestAxisHasNearlyTheLargestMoment) {
    Random random(813);
    Worst error("longest axis in float", 2e-6);
    for (int k = 0; k < 2'000; ++k) {
        math_d::agaa_SecondMoments m{glm::dvec3(0), glm::dvec3(0)};
        const double size = random.decades(1e-6, 1e6);
        const glm::dvec3 stretch = random.direction() * random.decades(0.1, 10);
        for (unsigned i = 1 + random.below(16); i > 0; --i) {
            const glm::dvec3 v = random.direction();
            math_d::agaa_addSecondMoments(m, 1, size * (v + stretch * glm::dot(stretch, v)));
        }
        glm::dvec3 axis;
        const double moment = math_d::agaa_longestAxis(m, axis);
        EXPECT_NEAR(glm::length(axis), 1, 1e-12);
        double largest = 0;
        for (int i = 0; i < 300; ++i) {
            const glm::dvec3 other = random.direction();
            largest = std::max(largest, math_d::agaa_momentAlong(m, other, other));
        }
        EXPECT_GE(moment, 0.9 * largest);
        glm::vec3 axisInFloat;
        const math_f::agaa_SecondMoments f{glm::vec3(m.squares), glm::vec3(m.mixed)};
        error.relative(double(math_f::agaa_longestAxis(f, axisInFloat)), moment);
    }
    glm::vec3 axis;
    EXPECT_EQ(math_f::agaa_longestAxis(math_f::agaa_noSecondMoments(), axis), 0);
    EXPECT_EQ(axis, glm::vec3(0));
}

// The variance of unit vectors to a light from normally distributed positions, to the order that is kept.
TEST(SecondMoments, DirectionsOfALightVaryAsItsDistanceSays) {
    Random random(814);
    Worst error("variance of directions, of far lights, relative", 0.01);
    for (int k = 0; k < 200; ++k) {
        std::vector<glm::dvec3> positions(2000);
        const glm::dvec3 stretch = random.direction() * random.range(0, 2);
        math_d::agaa_SecondMoments moments = math_d::agaa_noSecondMoments();
        glm::dvec3 mean(0);
        for (glm::dvec3& p : positions) {
            const glm::dvec3 v = random.direction() * random.unit();
            p = v + stretch * glm::dot(stretch, v);
            mean += p / double(positions.size());
        }
        for (const glm::dvec3& p : positions)
            math_d::agaa_addSecondMoments(moments, 1 / double(positions.size()), p - mean);
        const glm::dvec3 d = random.direction() * random.range(20, 100);
        glm::dvec3 direction(0);
        for (const glm::dvec3& p : positions)
            direction += glm::normalize(mean + d - p) / double(positions.size());
        error.relative(math_d::agaa_directionVariance(moments, d), 1 - glm::dot(direction, direction));
        // A light at the position itself is in all directions.
        EXPECT_LT(math_d::agaa_directionVariance(moments, glm::dvec3(0)), 1 + 1e-12);
        EXPECT_GT(math_d::agaa_directionVariance(moments, glm::dvec3(0)), 0.99);
    }
    EXPECT_EQ(math_f::agaa_directionVariance(math_f::agaa_noSecondMoments(), glm::vec3(0)), 0);
}

} // namespace
