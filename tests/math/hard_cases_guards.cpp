// Hard cases 37, 43 and 56 of docs/numerics.md: values that are not finite.
#include <bit>
#include <cfloat>

#include "guards_fast_math.h"
#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

TEST(HardCase37_BadMaterial, OneSampleMovesTheMeanByItsWeight) {
    Random random(237);
    HardCaseFigures figures(37, "change of a mean by one bad sample of n, times n", 1.001);
    const float listed[] = {nanF(), -nanF(), infinityF(), -infinityF(), FLT_MAX, -FLT_MAX, 65504.0f, -1.0f};
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = 2u << random.below(5), bad = random.below(n);
        const float wrong = listed[random.below(8)];
        unsigned sum = 0, reference = 0, flags = 0;
        float naive = 0, naiveReference = 0;
        for (unsigned s = 0; s < n; ++s) {
            const float right = random.rangeF(0, 1), v = s == bad ? wrong : right;
            unsigned flag = 0;
            sum += math_f::agaa_quantise(math_f::agaa_sanitise(v, 0.0f, 1.0f, flag), 16);
            reference += math_f::agaa_quantise(right, 16);
            flags += flag;
            naive += v / float(n);
            naiveReference += right / float(n);
        }
        ASSERT_EQ(flags, std::isfinite(wrong) ? 0u : 1u); // the counter of bad fragments
        figures.add(
            std::abs(double(naive) - double(naiveReference)) * n,
            std::abs(double(math_f::agaa_meanOfSum(sum, n, 16)) - double(math_f::agaa_meanOfSum(reference, n, 16))) *
                n);
    }
}

// x * (1 / y), as GPUs compute it: the reciprocal of what exceeds 2^126 is denormal and becomes 0.
static float quotientOnGpu(float x, float y) {
    const float reciprocal = 1 / y;
    return x * (std::abs(reciprocal) < FLT_MIN ? 0 : reciprocal);
}

TEST(HardCase37_BadMaterial, QuotientsNearTheLargestFloat) {
    Random random(337);
    size_t lost = 0;
    for (int i = 0; i < 100000; ++i) {
        const float y = i == 0 ? FLT_MAX : float(random.decades(1e-37, 3.4e38)), x = y * random.rangeF(0.001f, 1);
        const double expected = double(x) / double(y);
        lost += quotientOnGpu(x, y) == 0;
        const float scale = math_f::agaa_divisionScale(y);
        ASSERT_NEAR(quotientOnGpu(x * scale, y * scale), expected, 2e-7 * expected) << x << " / " << y;
        ASSERT_NEAR(math_f::agaa_quotient(x, y), expected, 2e-7 * expected) << x << " / " << y;
    }
    EXPECT_GT(lost, 500u) << "without the scale";
    unsigned flag = 0;
    EXPECT_EQ(math_f::agaa_sanitiseEmission({0, 3e38f, 1.5e38f}, 16.0f, flag), glm::vec3(0, 16, 8));
}

TEST(HardCase37_BadMaterial, SanitisedAndCounted) {
    const float bad[] = {nanF(), -nanF(), infinityF(), -infinityF()};
    for (float x : bad) {
        unsigned flag = 0;
        EXPECT_FALSE(math_f::agaa_isFinite(x));
        EXPECT_FALSE(math_d::agaa_isFinite(x));
        EXPECT_EQ(math_f::agaa_sanitise(x, 0.25f, 1.0f, flag), 0.25f);
        EXPECT_EQ(flag, 1u);
        flag = 0;
        EXPECT_EQ(math_f::agaa_sanitise3({0.5f, x, 2.0f}, 0.0f, 1.0f, flag), glm::vec3(0.5f, 0, 1));
        EXPECT_EQ(flag, 1u);
    }
    for (float x : extremeFloats()) {
        unsigned flag = 0;
        EXPECT_TRUE(math_f::agaa_isFinite(x)) << x;
        const float s = math_f::agaa_sanitise(x, 0.0f, 65504.0f, flag);
        EXPECT_TRUE(s >= 0.0f && s <= 65504.0f) << x;
        EXPECT_EQ(flag, 0u) << x;
    }
    for (float x : bad) {
        unsigned flag = 0;
        EXPECT_EQ(math_f::agaa_sanitiseNormal({0.5f, x, 0.5f}, flag), glm::vec3(0, 0, 1));
        EXPECT_EQ(flag, 1u);
    }
    for (float x : extremeFloats()) {
        unsigned flag = 0;
        EXPECT_NEAR(glm::length(math_f::agaa_sanitiseNormal({x, 0.5f * x, -x}, flag)), 1, 1e-6) << x;
        EXPECT_EQ(flag, 0u) << x;
    }
    // Emission beyond the range keeps its hue, whatever its size.
    for (const float size : {1.0f, 4.0f, 1e30f}) {
        unsigned flag = 0;
        const glm::vec3 e = math_f::agaa_sanitiseEmission(glm::vec3(0.5f, 8, 2) * size, 16.0f, flag);
        EXPECT_EQ(e, size > 2 ? glm::vec3(1, 16, 4) : glm::vec3(0.5f, 8, 2));
        EXPECT_EQ(math_f::agaa_sanitiseEmission({nanF(), 32 * size, -size}, 16.0f, flag), glm::vec3(0, 16, 0));
        EXPECT_EQ(flag, 1u);
    }
    // A flag that is set stays set.
    unsigned flag = 1;
    math_f::agaa_sanitise(0.5f, 0.0f, 1.0f, flag);
    EXPECT_EQ(flag, 1u);
    // One bad sample of n moves the mean by at most its weight.
    unsigned sum = 0;
    for (int i = 0; i < 8; ++i)
        sum += math_f::agaa_quantise(i == 3 ? nanF() : 0.5f, 11);
    EXPECT_NEAR(math_f::agaa_meanOfSum(sum, 8, 11), 0.5f * 7.0f / 8.0f, 1e-3f);
}

TEST(HardCase43_InfiniteLuminance, DemandsTheMostSamples) {
    Random random(243);
    HardCaseFigures figures(43, "samples of a pixel that are missing or too many", 0.0);
    for (int i = 0; i < 120000; ++i) {
        const unsigned most = 2u << random.below(5);
        float lowest = float(random.decades(1e-3, 10)), highest = lowest + float(random.decades(1e-3, 10));
        const float c = 4;
        if (i % 4 == 0)
            highest = i % 8 ? infinityF() : nanF();
        if (i % 16 < 2)
            lowest = highest;
        const double range = double(highest) - double(lowest), k = double(c) * range;
        if (std::isfinite(range) && std::abs(k - std::round(k)) < 1e-4)
            continue; // at a whole number rounding decides
        const bool counts = !(range < std::max(0.1, double(highest) * 0.1));
        const double expected =
            std::isfinite(range) ? std::clamp(std::ceil(counts ? k : 0.0), 1.0, double(most)) : most;
        // The printed form: comparisons with a NaN are false, and an infinite number becomes any integer.
        const float printed = c * (highest - lowest);
        const double naive = printed >= 1.0f ? std::min(std::ceil(double(printed)), double(most)) : 1.0;
        const float ours = math_f::agaa_shadingCount(lowest, highest, 0.1f, 0.1f, c);
        figures.add(std::abs(std::isfinite(range) ? 0.0 : naive - expected),
                    std::abs(math_f::agaa_wholeCount(ours, 1, most) - expected));
    }
}

// One pass may flush denormals and another keep them. A cutoff is the same cutoff in both.
TEST(HardCase56_Denormals, AlphaAndCutoffsAreZero) {
    Random random(156);
    for (int i = 0; i < 1000; ++i) {
        const float denormal = std::bit_cast<float>((1 + random.below((1u << 23) - 1)) | (random.below(2) << 31));
        ASSERT_EQ(std::bit_cast<unsigned>(math_f::agaa_sanitiseAlpha(denormal)), 0u) << denormal;
    }
    EXPECT_EQ(math_f::agaa_sanitiseAlpha(FLT_MIN), FLT_MIN);
    EXPECT_EQ(math_f::agaa_sanitiseAlpha(-FLT_MIN), -FLT_MIN);
    for (const float bad : {nanF(), -nanF(), infinityF(), -infinityF()})
        EXPECT_EQ(math_f::agaa_sanitiseAlpha(bad), 0.0f);
}

TEST(HardCase56_FoldedGuards, SurviveFastMath) {
    Random random(256);
    HardCaseFigures figures(56, "share of NaN and infinities that pass", 0.0);
    Share passed, comparisonPassed;
    for (int i = 0; i < 100000; ++i) {
        // Any payload and sign; an infinity among a few.
        const unsigned payload = i % 8 ? random.below(1u << 23) : 0;
        volatile float source = std::bit_cast<float>(0x7F800000u | payload | (random.below(2) << 31));
        const float x = source;
        unsigned flag = 0;
        passed.add(fastMathIsFinite(x) || fastMathSanitise(x, 0.0f, 1.0f, flag) != 0.0f || flag != 1);
        if (payload != 0)
            comparisonPassed.add(fastMathComparesEqualToItself(x));
        const float finite = std::bit_cast<float>(random.below(0x7F800000u) | (random.below(2) << 31));
        ASSERT_TRUE(fastMathIsFinite(finite)) << finite;
    }
    figures.naive(comparisonPassed.value());
    figures.ours(passed.value(), passed.inputs());
}
