// Where covered samples lie and which surface they show (surface_resolve.glsl, agaa_coverageMiddle).
#include "shader_math.h"

#include <gtest/gtest.h>

#include <random>

namespace {

glm::uvec4 randomMask(std::mt19937& random, uint32_t samples) {
    glm::uvec4 mask(0u);
    for (uint32_t word = 0; word < samples / 32; ++word)
        mask[int(word)] = uint32_t(random() & random());
    return mask;
}

TEST(CoveredSamples, MiddleAndNumberAreThoseOfOneByOne) {
    std::mt19937 random(1);
    for (int run = 0; run < 3000; ++run) {
        const uint32_t samples = 32u << run % 3;
        const glm::uvec4 mask = randomMask(random, samples);
        glm::dvec2 sum(0);
        uint32_t count = 0;
        for (uint32_t i = 0; i < samples; ++i)
            if (math_f::agaa_isCovered(mask, i)) {
                ASSERT_EQ(math_f::agaa_coveredSample(mask, count++), i);
                sum += math_d::agaa_coveragePosition(i, samples);
            }
        if (count == 0)
            continue;
        const glm::dvec2 middle(math_f::agaa_coverageMiddle(mask, samples));
        ASSERT_LE(glm::length(middle - sum / double(count)), 1e-6);
    }
}

TEST(CoveredSamples, BehindIsWhatDoubleSays) {
    std::mt19937 random(2);
    const auto uniform = [&](float low, float high) {
        return std::uniform_real_distribution<float>(low, high)(random);
    };
    uint32_t mixed = 0;
    for (int run = 0; run < 3000; ++run) {
        const uint32_t samples = 32u << run % 3;
        const glm::uvec4 both = randomMask(random, samples);
        const auto plane = [&] {
            const float low = uniform(-0.2f, 0.2f);
            return math_f::agaa_DepthPlane{
                uniform(0, 0.2f), {uniform(-1, 1), uniform(-1, 1)}, {low, low + uniform(0, 0.5f)}};
        };
        const math_f::agaa_DepthPlane a = plane(), b = plane();
        const glm::uvec4 hidden = math_f::agaa_samplesBehind(a, b, both, false, samples);
        ASSERT_EQ(hidden & ~both, glm::uvec4(0u));
        mixed += hidden != both && hidden != glm::uvec4(0u);
        for (uint32_t i = 0; i < samples; ++i) {
            const glm::dvec2 at = math_d::agaa_coveragePosition(i, samples);
            const auto depth = [&at](const math_f::agaa_DepthPlane& p) {
                return glm::clamp(double(p.depth) + glm::dot(glm::dvec2(p.slope), at), double(p.range.x),
                                  double(p.range.y));
            };
            const double by = depth(a) - depth(b);
            if (math_f::agaa_isCovered(both, i) && std::fabs(by) > 1e-6) {
                ASSERT_EQ(math_f::agaa_isCovered(hidden, i), by > 0);
            }
        }
        // Of equal depths the second shows where it wins.
        ASSERT_EQ(math_f::agaa_samplesBehind(a, a, both, true, samples), both);
        ASSERT_EQ(math_f::agaa_samplesBehind(a, a, both, false, samples), glm::uvec4(0u));
    }
    EXPECT_GT(mixed, 1000u);
}

} // namespace
