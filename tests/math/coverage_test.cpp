// Coverage of alpha-masked surfaces (src/shaders/math/alpha_coverage.glsl).
#include "test_support.h"

using namespace test_math;

namespace {

// Where float and double disagree about a sample, the plane passes within float's rounding of the cutoff there.
TEST(LocatedMask, FloatAgreesWithDoubleUpToRounding) {
    Random random(24);
    std::size_t disagreements = 0;
    Worst worst("margin where float and double disagree, of the largest term", 4 * 0x1p-24);
    for (int i = 0; i < 1000000; ++i) {
        const float cutoff = random.rangeF(0.001, 1);
        const glm::vec2 gradient(random.rangeF(-1, 1) * float(random.decades(1e-6, 1)), random.rangeF(-1, 1));
        const glm::vec2 offset(random.rangeF(-0.5, 0.5), random.rangeF(-0.5, 0.5));
        // The edge passes through the sample, but for rounding.
        const float alpha = cutoff - glm::dot(gradient, offset) * (1 + random.rangeF(-1, 1) * 1e-7f);
        if (math_f::agaa_isInCutout(alpha, cutoff, gradient, offset) ==
            math_d::agaa_isInCutout(alpha, cutoff, glm::dvec2(gradient), glm::dvec2(offset)))
            continue;
        ++disagreements;
        const double margin = double(alpha) - double(cutoff) + glm::dot(glm::dvec2(gradient), glm::dvec2(offset));
        worst.add(std::abs(margin) / std::max({double(alpha), double(cutoff), std::abs(double(gradient.x)) * 0.5,
                                               std::abs(double(gradient.y)) * 0.5}));
    }
    EXPECT_GT(disagreements, 100u); // else nothing was tested
}

TEST(LocatedMask, ExtremeInputIsDecidedAndTheCentreIsAHardTest) {
    for (float alpha : {0.0f, 0.25f, 0.5f, 1.0f, 65504.0f, -65504.0f}) {
        for (float cutoff : {1e-30f, 0.25f, 0.5f, 1.0f, 65504.0f}) {
            const bool hard = alpha >= cutoff;
            EXPECT_EQ(math_f::agaa_isInCutout(alpha, cutoff, {0, 0}, {0.5f, -0.5f}), hard);
            for (float slope : {0.0f, 1e-30f, 1.0f, 131008.0f})
                EXPECT_EQ(math_f::agaa_isInCutout(alpha, cutoff, {slope, -slope}, {0, 0}), hard);
        }
    }
}

TEST(TranslucentMask, AlphaThatIsNoNumberCoversNothing) {
    for (const float alpha : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity(), -1.0f})
        for (unsigned hash : {0u, 12345u, ~0u})
            EXPECT_EQ(math_f::agaa_translucentMask(alpha, 8, 0, 1, hash), 0u) << alpha;
    EXPECT_EQ(math_f::agaa_translucentMask(2, 8, 0, 1, 7), 255u);
}

// Where float and double disagree about a sample, the surface passes within float's rounding of the cutoff there.
TEST(LocatedMask, FourPointsInFloatAgreeWithDoubleUpToRounding) {
    Random random(25);
    std::size_t disagreements = 0;
    Worst worst("margin where float and double disagree, of the largest term", 16 * 0x1p-24);
    for (int i = 0; i < 1000000; ++i) {
        glm::vec4 alpha(random.rangeF(0, 1), random.rangeF(0, 1), random.rangeF(0, 1), random.rangeF(0, 1));
        const glm::vec2 offset(random.rangeF(-0.5, 0.5), random.rangeF(-0.5, 0.5));
        const glm::dvec2 at = glm::dvec2(offset) * 2.0 + 0.5;
        const double value = glm::mix(glm::mix(double(alpha.x), double(alpha.y), at.x),
                                      glm::mix(double(alpha.z), double(alpha.w), at.x), at.y);
        const float cutoff = float(value * (1 + double(random.rangeF(-1, 1)) * 1e-7)); // but for rounding
        if (math_f::agaa_isInCutout4(alpha, cutoff, offset) ==
            math_d::agaa_isInCutout4(glm::dvec4(alpha), cutoff, glm::dvec2(offset)))
            continue;
        ++disagreements;
        worst.add(std::abs(value - double(cutoff)) / std::max(1.0, std::abs(value)));
    }
    EXPECT_GT(disagreements, 100u); // else nothing was tested
}

// Over pixels: the mean of a layer's coverage is alpha, and two layers of one half cover three quarters, at every
// number of samples and way of splitting a pixel into texels.
TEST(TranslucentMask, LayersOverlapLikeIndependentOnes) {
    struct Split {
        unsigned samples, groups;
    };
    for (const Split split : {Split{1, 1}, Split{4, 1}, Split{4, 2}, Split{4, 4}, Split{4, 8}, Split{8, 1},
                              Split{16, 1}, Split{32, 1}, Split{8, 4}, Split{2, 1}, Split{1, 4}}) {
        for (unsigned frame : {0u, 1u, 77u}) {
            double one = 0, two = 0;
            constexpr unsigned side = 192;
            for (unsigned y = 0; y < side; ++y)
                for (unsigned x = 0; x < side; ++x) {
                    const unsigned a = math_f::agaa_translucencyHash(x, y, 11, frame),
                                   b = math_f::agaa_translucencyHash(x, y, 12, frame);
                    for (unsigned g = 0; g < split.groups; ++g) {
                        const unsigned first = math_f::agaa_translucentMask(0.5f, split.samples, g, split.groups, a);
                        const unsigned second = math_f::agaa_translucentMask(0.5f, split.samples, g, split.groups, b);
                        one += glm::bitCount(first);
                        two += glm::bitCount(first | second);
                    }
                }
            const double all = double(side) * side * split.samples * split.groups;
            EXPECT_NEAR(one / all, 0.5, 0.01) << split.samples << "x" << split.groups;
            EXPECT_NEAR(two / all, 0.75, 0.01) << split.samples << "x" << split.groups << " frame " << frame;
        }
    }
}

// Small shares are not lost to the steps of the random number.
TEST(TranslucentMask, MeanOfALayerIsItsAlpha) {
    struct Split {
        unsigned samples, groups;
    };
    Worst worst("mean coverage less alpha, in standard deviations of the mean", 4);
    for (const Split split : {Split{1, 1}, Split{2, 1}, Split{4, 1}, Split{4, 8}, Split{1, 4}, Split{32, 1}})
        for (const float alpha : {0.002f, 0.05f, 0.3f, 0.999f}) {
            constexpr unsigned side = 1024;
            double sum = 0;
            for (unsigned y = 0; y < side; ++y)
                for (unsigned x = 0; x < side; ++x)
                    sum += glm::bitCount(math_f::agaa_translucentMask(alpha, split.samples, (x + y) % split.groups,
                                                                      split.groups,
                                                                      math_f::agaa_translucencyHash(x, y, 11, 0)));
            const double count = double(side) * side;
            const double part = double(alpha) * split.samples - std::floor(double(alpha) * split.samples);
            worst.add(std::abs(sum - double(alpha) * split.samples * count) / std::sqrt(part * (1 - part) * count));
        }
}

// The mean over frames converges in each pixel: what stands still in frame 0 is gone.
TEST(TranslucentMask, FramesOfAPixelConverge) {
    Worst worst("coverage of a pixel over 512 frames, one sample", 0.1);
    for (unsigned pixel = 0; pixel < 64; ++pixel) {
        unsigned covered = 0;
        for (unsigned frame = 1; frame <= 512; ++frame)
            covered += math_f::agaa_translucentMask(0.3f, 1, 0, 1, math_f::agaa_translucencyHash(pixel, 5, 9, frame));
        worst.absolute(covered / 512.0, 0.3);
    }
}

TEST(TranslucentMask, EndsAreExact) {
    for (unsigned samples : {1u, 2u, 4u, 8u, 16u, 32u}) {
        const unsigned all = 0xFFFFFFFFu >> (32 - samples);
        for (unsigned seed = 0; seed < 1000; ++seed) {
            const unsigned hash = math_f::agaa_hash(seed);
            EXPECT_EQ(math_f::agaa_translucentMask(0, samples, 0, 1, hash), 0u);
            EXPECT_EQ(math_f::agaa_translucentMask(1, samples, 0, 1, hash), all);
            EXPECT_EQ(math_f::agaa_translucentMask(65504.0f, samples, 0, 1, hash), all);
            EXPECT_EQ(math_f::agaa_translucentMask(-1, samples, 0, 1, hash), 0u);
        }
    }
}

} // namespace
