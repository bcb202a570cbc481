// Numbers of samples and differences between samples (math/adaptive.glsl): float against double over random and extreme
// input, and known values. Hard cases 12, 13 and 15.
#include "shader_math.h"
#include "test_support.h"

#include <gtest/gtest.h>

#include <limits>

using namespace test_math;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();

} // namespace

TEST(MathAdaptive, NormalStepsAreSharesOfTheAngle) {
    Random random(3);
    for (int round = 0; round < 20000; ++round) {
        const glm::vec3 a(random.direction());
        const glm::vec3 b(glm::normalize(glm::dvec3(a) + random.direction() * random.decades(1e-5, 2)));
        const float cosine = float(1 - random.decades(1e-4, 1));
        const double exact = math_d::agaa_normalStep(glm::dvec3(a), glm::dvec3(b), double(cosine));
        EXPECT_NEAR(math_f::agaa_normalStep(a, b, cosine), exact, 1e-5 * exact + 1e-6);
    }
    // An angle of which the cosine is the threshold is one step, a flipped normal more than any other.
    const glm::vec3 z(0, 0, 1), tilted(std::sin(0.2f), 0, std::cos(0.2f));
    EXPECT_NEAR(math_f::agaa_normalStep(z, tilted, std::cos(0.2f)), 1, 1e-4);
    EXPECT_EQ(math_f::agaa_normalStep(z, z, 1), 0);
    EXPECT_GT(math_f::agaa_normalStep(z, -z, 0.95f), math_f::agaa_normalStep(z, glm::vec3(1, 0, 0), 0.95f));
    EXPECT_TRUE(std::isfinite(math_f::agaa_normalStep(z, -z, 1)));
}

// Hard case 15: samples of one plane do not differ, whatever its slope and distance.
TEST(MathAdaptive, SamplesOfOnePlaneDoNotDiffer) {
    Random random(5);
    for (int round = 0; round < 20000; ++round) {
        const double distance = random.decades(0.1, 1e5), width = distance * 1e-3;
        const glm::dvec3 normal = random.direction();
        glm::dvec3 along = glm::cross(normal, random.direction());
        const glm::vec3 offset(glm::normalize(along) * width *
                               random.decades(0.1, 100)); // slopes of up to 100 pixel widths
        const float step = math_f::agaa_planeStep(offset, glm::vec3(normal), glm::vec3(normal), float(width));
        EXPECT_LT(step, 1e-4) << distance;
    }
    EXPECT_EQ(math_f::agaa_planeStep(glm::vec3(0), glm::vec3(0, 0, 1), glm::vec3(0, 0, 1), 0), 0);
    // A curved surface: the nearer of both planes counts.
    EXPECT_NEAR(math_f::agaa_planeStep(glm::vec3(1, 0, 0), glm::vec3(0, 0, 1), glm::vec3(0.6f, 0, 0.8f), 0.5f), 0,
                1e-6);
}

TEST(MathAdaptive, WholeCountsStayInRange) {
    for (float k : {-infinity, -1e30f, -1.0f, 0.0f, 1e-40f, 1.0f, 3.5f, 1e9f, 1e30f, infinity, notANumber})
        for (unsigned least : {1u, 2u, 9u})
            for (unsigned most : {9u, 16u, 32u}) {
                const unsigned count = math_f::agaa_wholeCount(k, least, most);
                EXPECT_GE(count, least) << k;
                EXPECT_LE(count, most) << k;
            }
    EXPECT_EQ(math_f::agaa_wholeCount(2.0f, 1, 9), 2u);
    EXPECT_EQ(math_f::agaa_wholeCount(2.01f, 1, 9), 3u);
    EXPECT_EQ(math_f::agaa_wholeCount(notANumber, 1, 9), 9u);
}

TEST(MathAdaptive, ShadingCountsBeginAtBothThresholds) {
    EXPECT_EQ(math_f::agaa_shadingCount(0.5f, 0.5f, 0, 0, 4), 0);
    EXPECT_EQ(math_f::agaa_shadingCount(0.9f, 1.0f, 0.125f, 0.0625f, 4), 0) << "less than the share of the largest";
    EXPECT_EQ(math_f::agaa_shadingCount(0.0f, 0.05f, 0.125f, 0.0625f, 4), 0) << "less than the minimum";
    EXPECT_NEAR(math_f::agaa_shadingCount(0.25f, 0.75f, 0.125f, 0.0625f, 4), 2, 1e-6);
    Random random(7);
    for (int round = 0; round < 20000; ++round) {
        const float lowest = float(random.range(0, 1)), highest = lowest + float(random.range(0, 1)) * (1 - lowest);
        const float count = math_f::agaa_shadingCount(lowest, highest, 0.125f, 0.0625f, 4);
        EXPECT_GE(count, 0);
        EXPECT_LE(count, 4.0001f);
    }
}

TEST(MathAdaptive, PackedCountsComeBack) {
    for (unsigned covered = 1; covered <= 32; ++covered)
        for (unsigned count = 1; count <= covered; ++count)
            for (int step = 0; step <= 20; ++step) {
                const float left = float(step) / 20;
                const unsigned word = math_f::agaa_packCount(covered, count, left);
                EXPECT_EQ(math_f::agaa_coveredIn(word), covered);
                EXPECT_EQ(math_f::agaa_countIn(word), count);
                EXPECT_NEAR(math_f::agaa_leftIn(word), left, 0.5 / 65535 + 1e-7);
            }
    EXPECT_EQ(math_f::agaa_packCount(0, 0, 0), 0u);
    EXPECT_EQ(math_f::agaa_leftIn(math_f::agaa_packCount(9, 2, 1e30f)), 1);
    EXPECT_EQ(math_f::agaa_countIn(math_f::agaa_packCount(9, 2, -1)), 2u);
}

TEST(MathAdaptive, BinsHoldWhatLiesBetweenTheirEdges) {
    for (unsigned bin = 0; bin < math_f::agaa_bins(); ++bin) {
        const double edge = math_d::agaa_differenceOfBin(bin), next = math_d::agaa_differenceOfBin(bin + 1);
        EXPECT_EQ(math_f::agaa_differenceBin(float(edge + 0.01 * (next - edge))), bin);
        EXPECT_EQ(math_f::agaa_differenceBin(float(next - 0.01 * (next - edge))), bin);
        EXPECT_NEAR(math_f::agaa_differenceOfBin(bin), edge, 1e-5 * edge);
    }
    EXPECT_EQ(math_f::agaa_differenceBin(0), 0u);
    for (float large : {1e9f, 1e38f, infinity, notANumber})
        EXPECT_EQ(math_f::agaa_differenceBin(large), math_f::agaa_bins() - 1);
}

TEST(MathAdaptive, BucketsArePowersOfTwo) {
    const unsigned expected[] = {0, 1, 2, 4, 4, 8, 8, 8, 8, 16, 16};
    for (unsigned count = 0; count < std::size(expected); ++count)
        EXPECT_EQ(math_f::agaa_bucketOfCount(count), expected[count]) << count;
    EXPECT_EQ(math_f::agaa_bucketOfCount(17), 32u);
    EXPECT_EQ(math_f::agaa_bucketOfCount(32), 32u);
}

TEST(MathAdaptive, MeansOfCountsFollow) {
    float mean = 0;
    mean = math_f::agaa_meanOfCounts(mean, 3, 0.9f);
    EXPECT_EQ(mean, 3) << "begins with the first count";
    for (int frame = 0; frame < 40; ++frame)
        mean = math_f::agaa_meanOfCounts(mean, 1, 0.9f);
    EXPECT_NEAR(mean, 1, 0.05);
    EXPECT_EQ(math_f::agaa_meanOfCounts(5, 0, 0.9f), 0) << "pixels without geometry begin anew";
}
