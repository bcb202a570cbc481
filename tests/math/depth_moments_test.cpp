// Sums of coded depths against the moments of all depths, float against double.
#include <algorithm>
#include <numeric>

#include "test_support.h"

using namespace test_math;

namespace {

// An infinite, reversed projection: depth is near / distance.
constexpr double near = 0.1;
float depthAt(double distance) { return float(near / distance); }

struct Moments {
    double mean = 0, deviation = 0;
};

Moments momentsOf(const std::vector<double>& values) {
    Moments m;
    for (const double v : values)
        m.mean += v / double(values.size());
    for (const double v : values)
        m.deviation += (v - m.mean) * (v - m.mean) / double(values.size());
    m.deviation = std::sqrt(m.deviation);
    return m;
}

glm::uvec4 sumsOf(const std::vector<unsigned>& codes) {
    glm::uvec4 sums(0);
    for (const unsigned code : codes)
        for (unsigned m = 0; m < 4; ++m)
            sums[int(m)] += math_f::agaa_depthTerm(m, code);
    return sums;
}

math_f::agaa_StoredDepth storedDepth(const std::vector<double>& distances) {
    std::vector<unsigned> codes;
    for (const double distance : distances)
        codes.push_back(math_f::agaa_depthCode(depthAt(distance), 0, float(near), 0));
    return math_f::agaa_storedDepth(math_f::agaa_momentsOfCodes(sumsOf(codes), unsigned(codes.size())), 0, float(near),
                                    0);
}

TEST(DepthMoments, SumsHaveTheMomentsOfAllCodes) {
    Random random(411);
    double mean = 0, deviation = 0;
    for (int i = 0; i < 20000; ++i) {
        const unsigned middle = random.below(1u << 22), reach = 1 + random.below(1u << random.below(22));
        std::vector<unsigned> codes(1 + random.below(32));
        for (unsigned& code : codes)
            code = std::min(middle + random.below(reach), math_f::agaa_largestDepthCode());
        const Moments exact = momentsOf({codes.begin(), codes.end()});
        const auto stored = math_f::agaa_momentsOfCodes(sumsOf(codes), unsigned(codes.size()));
        mean = std::max(mean, std::abs(double(stored.mean) - exact.mean));
        deviation = std::max(deviation,
                             std::abs(double(stored.deviation) - exact.deviation) / std::max(exact.deviation, 2048.0));
    }
    EXPECT_LT(mean, 0.2);       // measured 0.125: floats from 2^21 on are a quarter apart
    EXPECT_LT(deviation, 4e-5); // measured 3.1e-5
}

TEST(DepthMoments, SumsOf32CodesFitTheirWords) {
    for (const unsigned code : {0u, 1u, 2047u, 2048u, 0x1FFFFFu, 0x200000u, 0x3FFFFFu}) {
        const auto m = math_f::agaa_momentsOfCodes(sumsOf(std::vector<unsigned>(32, code)), 32);
        EXPECT_EQ(m.mean, float(code));
        EXPECT_EQ(m.deviation, 0.0f) << "equal depths have no spread";
    }
}

// Samples of one surface, and of two surfaces with as many samples each.
TEST(DepthMoments, DistancesHaveTheMomentsOfAllDistances) {
    Random random(412);
    double nearMean = 0, nearDeviation = 0, twoMean = 0, twoDeviation = 0;
    for (int i = 0; i < 20000; ++i) {
        const double distance = random.decades(1e-3, 1e6);
        std::vector<double> distances(2 + random.below(31));
        for (double& d : distances)
            d = distance * (1 + 0.01 * random.unit());
        Moments exact = momentsOf(distances);
        auto stored = storedDepth(distances);
        nearMean = std::max(nearMean, std::abs(-double(stored.mean) / exact.mean - 1));
        nearDeviation = std::max(nearDeviation, std::abs(double(stored.deviation) - exact.deviation) / distance);
        const double other = distance * random.decades(1, 100);
        distances.assign(2 * (1 + random.below(16)), distance);
        std::fill(distances.begin() + std::ptrdiff_t(distances.size() / 2), distances.end(), other);
        exact = momentsOf(distances);
        stored = storedDepth(distances);
        twoMean = std::max(twoMean, std::abs(-double(stored.mean) / exact.mean - 1));
        twoDeviation = std::max(twoDeviation, std::abs(double(stored.deviation) - exact.deviation) / exact.mean);
        EXPECT_LE(stored.farthest, stored.mean);
        EXPECT_GE(stored.nearest, stored.mean);
        EXPECT_LE(stored.nearest, 0.0f);
    }
    EXPECT_LT(nearMean, 1e-5);        // measured 7.1e-6
    EXPECT_LT(nearDeviation, 1.5e-5); // measured 1.0e-5
    EXPECT_LT(twoMean, 1e-5);         // measured 7.4e-6
    EXPECT_LT(twoDeviation, 1e-5);    // measured 7.4e-6
}

TEST(DepthMoments, AnOrthographicViewHasLinearDepths) {
    const float p22 = -0.04f, p32 = 0.02f; // depth = p22 z + p32
    std::vector<unsigned> codes;
    std::vector<double> z;
    for (const float depth : {0.1f, 0.25f, 0.9f}) {
        codes.push_back(math_f::agaa_depthCode(depth, p22, p32, 1));
        z.push_back((double(depth) - double(p32)) / double(p22));
    }
    const Moments exact = momentsOf(z);
    const auto stored = math_f::agaa_storedDepth(math_f::agaa_momentsOfCodes(sumsOf(codes), 3), p22, p32, 1);
    EXPECT_NEAR(double(stored.mean), exact.mean, 2e-5);
    EXPECT_NEAR(double(stored.deviation), exact.deviation, 2e-5);
}

TEST(DepthMoments, AreFiniteAtExtremes) {
    const float extremes[] = {0.0f, 1.0f, -1.0f, 1e-38f, 1e38f, std::numeric_limits<float>::infinity(), std::nanf("")};
    for (const float a : extremes)
        for (const float b : extremes)
            for (const unsigned orthographic : {0u, 1u})
                for (const float p32 : {0.1f, 1e-30f, 1e30f, -0.1f}) {
                    const std::vector<unsigned> codes = {math_f::agaa_depthCode(a, 0.0f, p32, orthographic),
                                                         math_f::agaa_depthCode(b, 0.0f, p32, orthographic)};
                    for (const unsigned code : codes)
                        ASSERT_LE(code, math_f::agaa_largestDepthCode());
                    const auto stored = math_f::agaa_storedDepth(math_f::agaa_momentsOfCodes(sumsOf(codes), 2), 0.0f,
                                                                 p32, orthographic);
                    for (const float v : {stored.mean, stored.deviation, stored.nearest, stored.farthest})
                        ASSERT_TRUE(std::isfinite(v)) << a << ' ' << b << ' ' << p32;
                }
}

} // namespace
