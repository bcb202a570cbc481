// Sums of values over the samples of a pixel, and depths of positions (src/shaders/math/pixel_sums.glsl, depth.glsl).
#include "test_support.h"

#include <cmath>

using namespace test_math;

namespace {

TEST(PixelSums, MeansAreThoseOfDouble) {
    Random random(31);
    Worst values("mean of values of up to 128 samples, absolute", 1.3e-7);
    Worst depths("mean of depths of up to 128 samples, absolute", 1.2e-7);
    for (int i = 0; i < 50000; ++i) {
        uint32_t terms = 0, depthTerms = 0;
        double sum = 0, depthSum = 0;
        uint32_t samples = 0;
        while (samples < 128) { // events of several samples each
            const auto count = std::min(uint32_t(random.range(1, 40)), 128 - samples);
            const auto value = float(random.range(-1, 1)), depth = float(random.range(0, 1));
            terms += math_f::agaa_sumTerm(value * float(count));
            depthTerms += math_f::agaa_depthSumTerm(depth * float(count));
            sum += double(value) * count;
            depthSum += double(depth) * count;
            samples += count;
            if (random.range(0, 1) < 0.2)
                break;
        }
        values.absolute(double(math_f::agaa_meanOfTerms(terms, samples)), sum / samples);
        depths.absolute(double(math_f::agaa_meanOfDepthTerms(depthTerms, samples)), depthSum / samples);
    }
}

TEST(PixelSums, ExtremesDoNotOverflow) {
    for (const float value : {-1.0f, 0.0f, 1.0f}) {
        uint32_t terms = 0;
        for (int i = 0; i < 128; ++i)
            terms += math_f::agaa_sumTerm(value);
        EXPECT_EQ(math_f::agaa_meanOfTerms(terms, 128), value);
        EXPECT_EQ(math_f::agaa_meanOfTerms(math_f::agaa_sumTerm(128 * value), 128), value);
    }
    for (const float depth : {0.0f, 1.0f}) {
        uint32_t terms = 0;
        for (int i = 0; i < 128; ++i)
            terms += math_f::agaa_depthSumTerm(depth);
        EXPECT_EQ(math_f::agaa_meanOfDepthTerms(terms, 128), depth);
    }
    EXPECT_EQ(math_f::agaa_meanOfTerms(7, 0), 0.0f);
    EXPECT_EQ(math_f::agaa_meanOfDepthTerms(7, 0), 0.0f);
}

// Depths of a perspective and of an orthographic projection, ordinary and reversed, with a far plane and without.
TEST(PixelSums, DepthsOfPositionsReturn) {
    Random random(33);
    Worst error("depth of the view z of a depth, absolute", 3e-7);
    for (int i = 0; i < 100000; ++i) {
        const double near = random.decades(1e-3, 10), far = near * random.decades(10, 1e5);
        const bool isOrthographic = random.range(0, 1) < 0.3, isReversed = random.range(0, 1) < 0.5;
        double p22 = isOrthographic ? 1 / (near - far) : far / (near - far);
        double p32 = isOrthographic ? near / (near - far) : near * far / (near - far);
        if (isReversed) { // 1 - depth
            p22 = isOrthographic ? -p22 : -p22 - 1;
            p32 = isOrthographic ? 1 - p32 : -p32;
        }
        const auto depth = float(random.range(0.001, 0.999));
        const float z = math_f::agaa_viewZFromDepth(depth, float(p22), float(p32), isOrthographic);
        const float back = math_f::agaa_depthOfViewZ(z, float(p22), float(p32), isOrthographic);
        EXPECT_GE(back, 0.0f);
        EXPECT_LE(back, 1.0f);
        error.absolute(double(back), double(depth));
    }
    for (const float z : {0.0f, -0.0f, 1.0f, -1e30f, 1e30f}) {
        const float depth = math_f::agaa_depthOfViewZ(z, 0.0f, 0.1f, 0);
        EXPECT_TRUE(depth >= 0.0f && depth <= 1.0f) << z;
    }
}

} // namespace
