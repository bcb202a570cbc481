// Sums in attachments: what additive blending leaves of values, rounded to the format after every addition.
#include "test_support.h"

#include <algorithm>

using namespace test_math;

namespace {

// A channel of an attachment. Drivers round to the nearest code or truncate.
class Channel {
public:
    Channel(unsigned bits, bool truncates) : top_(float(math_f::agaa_maxCode(bits))), truncates_(truncates) {}

    void add(float source) {
        const float sum = std::clamp(float(code_) / top_ + std::clamp(source, 0.0f, 1.0f), 0.0f, 1.0f);
        code_ = unsigned(std::floor(sum * top_ + (truncates_ ? 0.0f : 0.5f)));
    }
    float texel() const { return float(code_) / top_; }

private:
    float top_;
    bool truncates_;
    unsigned code_ = 0;
};

struct Fragment {
    unsigned count;
    double value;
};

// Returns fragments that cover `covered` samples together.
std::vector<Fragment> fragmentsOf(Random& random, unsigned covered, bool isSigned) {
    std::vector<Fragment> list;
    const unsigned kind = random.below(4);
    while (covered > 0) {
        const unsigned count = kind == 0 ? 1 : kind == 1 ? covered : 1 + random.below(covered);
        const double extremes[] = {isSigned ? -1.0 : 0.0, 0.0, 0.5, 1.0};
        const double value = random.below(3) == 0 ? extremes[random.below(4)] : random.range(isSigned ? -1 : 0, 1);
        list.push_back({count, double(float(value))});
        covered -= count;
    }
    return list;
}

unsigned blended(const std::vector<Fragment>& list, unsigned n, unsigned bits, bool isSigned, bool truncates) {
    Channel channel(bits, truncates);
    for (const Fragment& fragment : list)
        channel.add(math_f::agaa_blendedValue(float(fragment.value), fragment.count, n, bits, isSigned));
    return math_f::agaa_blendedCode(channel.texel(), bits);
}

template <typename Visit> void forFormats(const Visit& visit) {
    for (const unsigned bits : {8u, 10u, 16u})
        for (const unsigned n : {1u, 2u, 4u, 8u, 16u, 32u})
            for (const bool isSigned : {false, true})
                visit(bits, n, isSigned);
}

} // namespace

// Each of m fragments rounds to half a code, which stands for n / count of the mean.
TEST(MathBlendedSums, MeansAreWithinTheRoundingOfTheFormat) {
    Random random(1);
    Worst worst("blended mean: error over m/2 codes of the format", 1.0 + 1e-3);
    forFormats([&](unsigned bits, unsigned n, bool isSigned) {
        for (int i = 0; i < 4000; ++i) {
            const unsigned count = 1 + random.below(n);
            const std::vector<Fragment> list = fragmentsOf(random, count, isSigned);
            double mean = 0;
            for (const Fragment& fragment : list)
                mean += fragment.count * fragment.value / count;
            const double codes = isSigned ? math_d::agaa_maxCode(bits - 1) : math_d::agaa_maxCode(bits);
            const double half = double(list.size()) / 2 * n / (count * codes);
            for (const bool truncates : {false, true}) {
                const unsigned sum = blended(list, n, bits, isSigned, truncates);
                const double found = isSigned ? math_f::agaa_signedMeanOfBlended(sum, count, n, bits)
                                              : math_f::agaa_meanOfBlended(sum, count, n, bits);
                worst.add((std::abs(found - mean) - 2e-7) / half);
            }
        }
    });
}

TEST(MathBlendedSums, FloatDiffersFromDoubleByOneCodeAtMost) {
    Random random(2);
    Worst codes("blended code: float against double", 1.0);
    Worst means("mean of a blended sum: float against double", 2.5e-7);
    forFormats([&](unsigned bits, unsigned n, bool isSigned) {
        for (int i = 0; i < 2000; ++i) {
            const unsigned count = 1 + random.below(n);
            const float v = random.rangeF(-1.5, 1.5);
            if (isSigned)
                codes.absolute(math_f::agaa_signedBlendCode(v, count, n, bits),
                               math_d::agaa_signedBlendCode(double(v), count, n, bits));
            else
                codes.absolute(math_f::agaa_blendCode(v, count, n, bits),
                               math_d::agaa_blendCode(double(v), count, n, bits));
            const unsigned sum = random.below(math_f::agaa_maxCode(bits) * count / n + 1);
            means.absolute(double(math_f::agaa_meanOfBlended(sum, count, n, bits)),
                           math_d::agaa_meanOfBlended(sum, count, n, bits));
            means.absolute(double(math_f::agaa_signedMeanOfBlended(sum, count, n, bits)),
                           math_d::agaa_signedMeanOfBlended(sum, count, n, bits));
        }
    });
}

TEST(MathBlendedSums, DoNotDependOnTheOrderOfFragments) {
    Random random(3);
    forFormats([&](unsigned bits, unsigned n, bool isSigned) {
        for (int i = 0; i < 500; ++i) {
            std::vector<Fragment> list = fragmentsOf(random, 1 + random.below(n), isSigned);
            const unsigned sum = blended(list, n, bits, isSigned, false);
            for (size_t k = list.size(); k > 1; --k)
                std::swap(list[k - 1], list[random.below(unsigned(k))]);
            ASSERT_EQ(blended(list, n, bits, isSigned, false), sum) << bits << ' ' << n << ' ' << isSigned;
            ASSERT_EQ(blended(list, n, bits, isSigned, true), sum) << bits << ' ' << n << ' ' << isSigned;
        }
    });
}

TEST(MathBlendedSums, ZerosAndFullScalesAreExact) {
    forFormats([&](unsigned bits, unsigned n, bool isSigned) {
        for (unsigned count = 1; count <= n; ++count) {
            const std::vector<Fragment> zeros(count, {1, 0.0});
            const unsigned sum = blended(zeros, n, bits, isSigned, false);
            EXPECT_EQ(isSigned ? math_f::agaa_signedMeanOfBlended(sum, count, n, bits)
                               : math_f::agaa_meanOfBlended(sum, count, n, bits),
                      0.0f);
        }
        for (const double full : {isSigned ? -1.0 : 1.0, 1.0}) {
            const unsigned sum = blended({{n, full}}, n, bits, isSigned, true);
            EXPECT_EQ(isSigned ? math_f::agaa_signedMeanOfBlended(sum, n, n, bits)
                               : math_f::agaa_meanOfBlended(sum, n, n, bits),
                      float(full));
        }
    });
}

TEST(MathBlendedSums, NonFiniteValuesCountAsZero) {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity()}) {
        EXPECT_EQ(math_f::agaa_blendCode(bad, 4, 8, 16), 0u);
        EXPECT_EQ(math_f::agaa_signedBlendCode(bad, 4, 8, 16), math_f::agaa_blendCentre(4, 8, 16));
    }
    EXPECT_EQ(math_f::agaa_meanOfBlended(7, 0, 8, 16), 0.0f);
    EXPECT_EQ(math_f::agaa_signedMeanOfBlended(7, 0, 8, 16), 0.0f);
}

// Masks of fragments are disjoint, so that their sum is their union.
TEST(MathBlendedSums, MasksAddUpToTheCoverage) {
    Random random(4);
    for (const unsigned n : {1u, 2u, 4u, 8u, 16u, 32u})
        for (int i = 0; i < 3000; ++i) {
            const bool truncates = i & 1;
            std::vector<Channel> channels((n + 7) / 8, Channel(8, truncates));
            unsigned rest = n == 32 ? ~0u : (1u << n) - 1u, all = 0;
            while (rest != 0 && random.below(5) != 0) {
                const unsigned mask = rest & (random.below(2) ? ~0u << random.below(n) : random.below(~0u));
                for (unsigned part = 0; part < channels.size(); ++part)
                    channels[part].add(math_f::agaa_blendedMask(mask, part));
                all |= mask;
                rest &= ~mask;
            }
            unsigned found = 0;
            for (unsigned part = 0; part < channels.size(); ++part)
                found |= math_f::agaa_blendedCode(channels[part].texel(), 8) << (8 * part);
            ASSERT_EQ(found, all) << n;
        }
}
