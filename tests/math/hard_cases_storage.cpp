// Hard cases 18, 19, 31, 32, 34 and 35 of docs/numerics.md: sums and means of stored values.
#include <algorithm>
#include <cfloat>

#include <glm/gtc/packing.hpp>

#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

namespace {

double codeOf(double x, unsigned bits) { return std::floor(x * double(math_f::agaa_maxCode(bits)) + 0.5); }

} // namespace

TEST(UnormChannels, RoundingAndTruncatingDriversStoreTheNearest) {
    Random random(212);
    for (unsigned bits : {8u, 10u, 16u}) {
        const double top = math_f::agaa_maxCode(bits);
        for (int i = 0; i < 200000; ++i) {
            const bool isCode = i % 2;
            const double code = isCode ? std::floor(double(random.rangeF(0, 1)) * top) : 0;
            const float x = isCode ? float(code / top) : random.rangeF(-0.1f, 1.1f);
            const double exact = isCode ? code : std::clamp(double(x), 0.0, 1.0) * top;
            const double stored = std::min(double(math_f::agaa_unormOf(x, bits)), 1.0) * top;
            ASSERT_EQ(std::floor(stored), std::floor(stored + 0.5));
            ASSERT_LE(std::abs(std::floor(stored) - exact), isCode ? 0.0 : 0.51);
        }
    }
}

TEST(HardCase18_ZeroCoverage, MeansAreZero) {
    Random random(218);
    HardCaseFigures figures(18, "error of a mean, some of which have no sample", 1e-7);
    for (int i = 0; i < 100000; ++i) {
        const unsigned bits = 1 + random.below(16), count = i % 4 ? random.below(33) : 0;
        const unsigned sum = count == 0 ? 0 : random.below(count * math_f::agaa_maxCode(bits) + 1);
        const double reference = math_d::agaa_meanOfSum(sum, count, bits);
        figures.add(std::abs(double(float(sum) / (float(count) * float(math_f::agaa_maxCode(bits)))) - reference),
                    std::abs(double(math_f::agaa_meanOfSum(sum, count, bits)) - reference));
        if (count == 0) {
            ASSERT_EQ(math_f::agaa_meanOfSum(12345, 0, bits), 0.0f);
            ASSERT_EQ(math_f::agaa_signedMeanOfSum(12345, 0, bits), 0.0f);
        }
    }
    EXPECT_EQ(math_f::agaa_momentsVariance(math_f::agaa_momentsInit(3.0f)), 0.0f);
    // A mean normal of no sample has a direction.
    glm::vec3 direction;
    float len;
    math_f::agaa_meanDirection(glm::vec3(0), {0, 1, 0}, direction, len);
    EXPECT_EQ(direction, glm::vec3(0, 1, 0));
    EXPECT_EQ(len, 0.0f);
}

TEST(HardCase19_OneSample, BitwiseThePointSample) {
    Random random(219);
    HardCaseFigures figures(19, "relative change of alpha² by one sample", 0.0);
    Share contracted;
    for (int i = 0; i < 100000; ++i) {
        // The variance, which a contracted product of the naive form makes positive or negative.
        math_f::agaa_Moments m = math_f::agaa_momentsInit(random.rangeF(-1e4, 1e4));
        const float x = random.rangeF(-1e4, 1e4);
        math_f::agaa_momentsAdd(m, x);
        ASSERT_EQ(math_f::agaa_momentsVariance(m), 0.0f);
        contracted.add(std::fma(-x, x, x * x) != 0.0f);

        const unsigned bits = i % 2 ? 16 : 10, n = 1u << random.below(6);
        const float a = float(random.decades(4.2e-6, 1));
        glm::vec3 normal(random.direction()), stored(0), diffuse(0), mean(0);
        for (int c = 0; c < 3; ++c) {
            stored[c] = math_f::agaa_signedMeanOfSum(math_f::agaa_signedCode(normal[c], bits), 1, bits);
            const unsigned code = math_f::agaa_quantise(random.rangeF(0, 1), bits);
            diffuse[c] = float(code) / float(math_f::agaa_maxCode(bits));
            mean[c] = math_f::agaa_meanOfSum(code, 1, bits);
        }
        glm::vec3 d;
        float len;
        math_f::agaa_meanDirection(stored, {0, 0, 1}, d, len);
        const float kept = math_f::agaa_varianceFloor(len, math_f::agaa_storedLengthBound(1, bits));
        const float widened = math_f::agaa_toksvigAlpha2(a, kept);
        figures.relative(double(math_f::agaa_toksvigAlpha2(a, len)), double(widened), double(a));

        // The colour of the aggregate of one sample is that of the sample, by its nth part.
        math_f::agaa_Surface point{}, aggregate{};
        point.diffuse = point.specular = diffuse;
        point.normal = aggregate.normal = d;
        point.meanLength = 1;
        point.alpha2 = a;
        aggregate.diffuse = aggregate.specular = mean;
        aggregate.meanLength = kept;
        aggregate.alpha2 = widened;
        const glm::vec3 v(random.direction()), l(random.direction());
        const float share = 1.0f / float(n);
        ASSERT_EQ(math_f::agaa_shade(point, v, l, i & 1, 0, 0) * share,
                  math_f::agaa_shade(aggregate, v, l, i & 1, 1, 0) * share);
    }
    EXPECT_GT(contracted.value(), 0.5);
}

TEST(HardCase31_RoundingOfSums, MeanOfCodesWithinHalfACode) {
    Random random(231);
    HardCaseFigures figures(31, "error of a mean of n samples, in codes", 0.51);
    for (unsigned bits : {8u, 10u, 11u, 16u}) {
        const double top = math_f::agaa_maxCode(bits);
        for (int i = 0; i < 25000; ++i) {
            const unsigned n = i % 2 ? 32 : 1 + random.below(32);
            unsigned sum = 0;
            double mean = 0.0, blended = 0.0;
            const float shared = random.rangeF(0, 1);
            for (unsigned s = 0; s < n; ++s) {
                const float v = i % 3 ? shared : random.rangeF(0, 1);
                sum += math_f::agaa_quantise(v, bits);
                mean += double(v) / n;
                blended += codeOf(double(v) / n, bits); // the nth part, rounded by the blender
            }
            figures.add(std::abs(blended - mean * top),
                        std::abs(double(math_f::agaa_meanOfSum(sum, n, bits)) - mean) * top);
        }
    }
}

TEST(HardCase32_BlackCrush, DarkRamp) {
    Random random(232);
    HardCaseFigures figures(32, "largest value that becomes black, in codes", 0.501);
    for (unsigned bits : {8u, 10u, 16u})
        for (unsigned n : {8u, 32u}) {
            double crushed = 0.0;
            for (int i = 0; i < 17000; ++i) {
                const double codes = random.range(0, 20);
                const float x = float(codes / math_f::agaa_maxCode(bits));
                if (codeOf(double(x) / n, bits) == 0)
                    crushed = std::max(crushed, codes);
                const bool isBlack = math_f::agaa_meanOfSum(n * math_f::agaa_quantise(x, bits), n, bits) == 0.0f;
                figures.ours(isBlack ? codes : 0.0);
            }
            EXPECT_NEAR(crushed, n / 2.0, 0.1);
            figures.naive(crushed);
        }
}

TEST(HardCase34_OverflowOfHalfFloats, SumsOfCodesDoNotOverflow) {
    Random random(234);
    HardCaseFigures figures(34, "error of a mean emission, relative to the range of the layout", 1e-5);
    const float listed[] = {3000, 65504, 1e5f, FLT_MAX};
    for (int i = 0; i < 100000; ++i) {
        const float range = i % 2 ? 65504.0f : 16.0f;
        const unsigned n = 1u << random.below(6);
        unsigned sum = 0;
        float half = 0;
        double reference = 0;
        for (unsigned s = 0; s < n; ++s) {
            const float v = random.below(4) ? float(random.decades(1e-3, 65504)) : listed[random.below(4)];
            unsigned bad = 0;
            // The dimmer channel: brighter emission keeps its hue.
            const glm::vec3 e = math_f::agaa_sanitiseEmission({v, 0.75f * v, 0}, range, bad);
            ASSERT_EQ(bad, 0u);
            sum += math_f::agaa_quantise(e.y / range, 16);
            half = asHalf(half + asHalf(0.75f * v));
            reference += 0.75 * double(std::min(v, range)) / n;
        }
        figures.add(std::abs(double(half) / n - reference) / double(range),
                    std::abs(double(math_f::agaa_meanOfSum(sum, n, 16)) - reference / double(range)));
    }
}

TEST(HardCase35_OrderOfAdditions, IntegerSumsDoNotDependOnIt) {
    Random random(235);
    HardCaseFigures figures(35, "difference between two orders of the same fragments", 0.0);
    double single = 0;
    for (int i = 0; i < 100000; ++i) {
        std::vector<float> values(2 + random.below(31));
        for (float& v : values)
            v = random.rangeF(0, 1);
        float half[2] = {}, full[2] = {}, mean[2] = {};
        for (int order = 0; order < 2; ++order) {
            unsigned sum = 0;
            for (float v : values) {
                half[order] = asHalf(half[order] + asHalf(v / float(values.size())));
                full[order] += v / float(values.size());
                sum += math_f::agaa_quantise(v, 16);
            }
            mean[order] = math_f::agaa_meanOfSum(sum, unsigned(values.size()), 16);
            for (std::size_t k = values.size(); k > 1; --k)
                std::swap(values[k - 1], values[random.below(unsigned(k))]);
        }
        single = std::max(single, std::abs(double(full[0] - full[1])));
        figures.add(std::abs(double(half[0] - half[1])), std::abs(double(mean[0] - mean[1])));
    }
    std::printf("[ measured ] difference between two orders in single precision: %.2g\n", single);
    EXPECT_GT(single, 1e-8);
}
