// Lookup and clipping of earlier frames: against known answers, and in float against double.
#include "shader_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

TEST(History, ColoursReturnFromLumaAndChroma) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> exponent(-12, 11);
    double worst = 0, worstSingle = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec3 c(std::exp(exponent(random)), std::exp(exponent(random)), std::exp(exponent(random)));
        const glm::dvec3 back = math_d::agaa_linearFromCompressed(math_d::agaa_compressedYCoCg(c));
        const glm::vec3 single = math_f::agaa_linearFromCompressed(math_f::agaa_compressedYCoCg(glm::vec3(c)));
        const double largest = std::max({c.x, c.y, c.z});
        worst = std::max(worst, glm::length(back - c) / largest);
        // Bright light is compressed toward 1, so that a step of float is a step of luma squared.
        worstSingle = std::max(worstSingle, glm::length(glm::dvec3(single) - c) / (largest * (1 + largest)));
    }
    EXPECT_LT(worst, 1e-10);
    EXPECT_LT(worstSingle, 1e-6);
}

TEST(History, ResultsAreFiniteAndInRange) {
    for (const float y : {-1.0f, 0.0f, 0.5f, 1.0f, 1.5f, 100.0f})
        for (const float chroma : {-2.0f, 0.0f, 2.0f}) {
            const glm::vec3 c = math_f::agaa_linearFromCompressed(glm::vec3(y, chroma, -chroma));
            for (int i = 0; i < 3; ++i) {
                EXPECT_GE(c[i], 0.0f);
                EXPECT_LE(c[i], 65504.0f);
            }
        }
}

TEST(History, TheCubicKeepsTexelsAndLines) {
    for (int i = 0; i <= 64; ++i) {
        const double x = i / 64.0;
        const glm::dvec4 w = math_d::agaa_catmullRom(x);
        EXPECT_NEAR(w.x + w.y + w.z + w.w, 1, 1e-12);
        EXPECT_NEAR(-w.x + w.z + 2 * w.w, x, 1e-12) << "a ramp";
        EXPECT_NEAR(w.x + w.z + 4 * w.w, x * x, 1e-12) << "a parabola";
        const glm::vec4 single = math_f::agaa_catmullRom(float(x));
        EXPECT_LT(glm::length(glm::dvec4(single) - w), 2e-7);
    }
    EXPECT_EQ(math_f::agaa_catmullRom(0.0f), glm::vec4(0, 1, 0, 0));
}

TEST(History, PointsOutsideABoxMoveToItsFace) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(-1, 1);
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 d(value(random), value(random), value(random));
        const glm::vec3 half = glm::abs(glm::vec3(value(random), value(random), value(random)));
        const float share = math_f::agaa_shareWithin(d, half);
        const glm::vec3 moved = glm::abs(share * d) - half;
        const float beyond = std::max({moved.x, moved.y, moved.z});
        EXPECT_LE(beyond, 1e-6f);
        if (share < 1) {
            EXPECT_GE(beyond, -1e-6f);
        }
    }
    EXPECT_EQ(math_f::agaa_shareWithin(glm::vec3(1, 0, 0), glm::vec3(0)), 0.0f);
    EXPECT_EQ(math_f::agaa_shareWithin(glm::vec3(0), glm::vec3(0)), 1.0f);
}

TEST(History, MotionVectorsHaveAnExactZero) {
    EXPECT_EQ(math_f::agaa_decodedMotion(32768.0f / 65535.0f), 0.0f);
    EXPECT_NEAR(math_f::agaa_decodedMotion(1.0f), 1.0f, 1e-6f);
    EXPECT_NEAR(math_f::agaa_decodedMotion(1.0f / 65535.0f), -1.0f, 1e-6f);
}

} // namespace
