// Hard cases of codes, guards, depth and statistics; the numbers are those of the list of
// numerically hard cases.
#include <algorithm>
#include <cfloat>

#include "guards_fast_math.h"
#include "test_support.h"

using namespace test_math;

TEST(HardCase10_NormalCodes, AllCodesRoundTrip) {
    int wrong = 0;
    for (unsigned x = 1; x <= 255; ++x) {
        for (unsigned y = 1; y <= 255; ++y) {
            const glm::vec3 n = math_f::agaa_decodeHemiOct8({x, y});
            ASSERT_NEAR(glm::length(n), 1.0f, 3e-7f);
            ASSERT_GE(n.z, 0.0f);
            wrong += math_f::agaa_encodeHemiOct8(n) != glm::uvec2(x, y);
        }
    }
    EXPECT_EQ(wrong, 0);
    // The other 511 of the 65536 pairs contain a 0, which only (0,0) uses, for "no geometry".
    for (unsigned k = 0; k <= 255; ++k) {
        ASSERT_NEAR(glm::length(math_f::agaa_decodeHemiOct8({0u, k})), 1.0f, 3e-7f);
        ASSERT_NEAR(glm::length(math_f::agaa_decodeHemiOct8({k, 0u})), 1.0f, 3e-7f);
    }
}

TEST(HardCase10_NormalCodes, PoleAndSeam) {
    EXPECT_EQ(math_f::agaa_decodeHemiOct8(math_f::agaa_encodeHemiOct8({0, 0, 1})), glm::vec3(0, 0, 1));
    Worst seam("azimuth 0 against 2 pi - 1e-6: degrees between the decoded normals", 0.6);
    for (double z : {0.0, 0.1, 0.5, 0.9, 0.999}) {
        const double r = std::sqrt(1 - z * z);
        const glm::vec3 a(r, r * 5e-7, z), b(r, -r * 5e-7, z);
        seam.add(degreesBetween(glm::dvec3(math_f::agaa_decodeHemiOct8(math_f::agaa_encodeHemiOct8(a))),
                                glm::dvec3(math_f::agaa_decodeHemiOct8(math_f::agaa_encodeHemiOct8(b)))));
    }
    Worst floor("Equation 1 between a normal and its decoded code", 9e-5);
    Random random(210);
    for (int i = 0; i < 200000; ++i) {
        const glm::vec3 n(random.hemisphere());
        const glm::vec3 d = math_f::agaa_decodeHemiOct8(math_f::agaa_encodeHemiOct8(n));
        floor.add(double(glm::dot(n - d, n - d)) / 4.0);
    }
}

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

TEST(HardCase11_SphereMapPoles, OctahedralHasNone) {
    for (unsigned bits : {8u, 11u, 16u}) {
        for (const glm::vec3& n :
             {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1), glm::vec3(0, -0.0f, 1), glm::vec3(-0.0f, 0, -1)}) {
            EXPECT_EQ(math_f::agaa_decodeOct(math_f::agaa_encodeOct(n, bits), bits), n);
        }
        // Every stored value decodes to a unit vector, those that no encoder writes too.
        const float top = static_cast<float>(math_f::agaa_maxCode(bits));
        Random random(211);
        for (int i = 0; i < 50000; ++i) {
            const glm::vec2 u(std::floor(random.rangeF(0, 1) * top) / top, i % 10 ? random.rangeF(0, 1) : 0);
            ASSERT_NEAR(glm::length(math_f::agaa_decodeOct(u, bits)), 1.0f, 3e-7f);
        }
    }
}

TEST(HardCase14_ShiftedVariance, AgainstDouble) {
    Random random(214);
    Worst variance("shifted variance, mean/sigma up to 1e6: relative", 1e-5);
    Worst mean("shifted mean: relative", 6e-7);
    int negative = 0;
    const int count = 50000;
    for (int i = 0; i < count; ++i) {
        const double mu = random.decades(1e-2, 1e4);
        const double sigma = mu / random.decades(1.0, 1e6);
        const int n = 2 + int(random.below(31));
        std::vector<float> x;
        for (int k = 0; k < n; ++k) {
            x.push_back(static_cast<float>(mu + sigma * random.range(-1.7, 1.7)));
        }
        math_f::agaa_Moments m = math_f::agaa_momentsInit(x[0]);
        double sum = 0.0, squares = 0.0;
        float rawSum = 0.0f, rawSquares = 0.0f;
        for (float v : x) {
            math_f::agaa_momentsAdd(m, v);
            sum += double(v) / n;
            rawSum += v / static_cast<float>(n);
            rawSquares += v * v / static_cast<float>(n);
        }
        for (float v : x)
            squares += (double(v) - sum) * (double(v) - sum) / n;
        mean.relative(m.shift + m.sum / m.count, sum);
        const double got = math_f::agaa_momentsVariance(m);
        ASSERT_GE(got, 0.0);
        if (squares > 0.0)
            variance.relative(got, squares);
        negative += rawSquares - rawSum * rawSum < 0.0f;
    }
    std::printf("[ measured ] E[x^2]-E[x]^2 negative in %.1f %%\n", 100.0 * negative / count);
    EXPECT_GT(negative, count / 20);
}

TEST(HardCase14_ShiftedVariance, TapsStayWithinTheSamples) {
    // Depths 1, 1, 1, 1, 20: 1.34 sigma before the mean is 5.4 behind the eye.
    Worst error("shadow taps along the depth: float against double, relative to the depth", 1e-5);
    Random random(215);
    for (int i = 0; i < 20000; ++i) {
        std::vector<float> z(1 + random.below(32));
        for (float& v : z)
            v = -float(random.decades(1, 100));
        if (i == 0)
            z = {-1, -1, -1, -1, -20};
        const auto [low, high] = std::minmax_element(z.begin(), z.end());
        math_f::agaa_Moments m = math_f::agaa_momentsInit(z[0]);
        double mean = 0, variance = 0;
        for (const float v : z) {
            math_f::agaa_momentsAdd(m, v);
            mean += double(v) / double(z.size());
        }
        for (const float v : z)
            variance += (double(v) - mean) * (double(v) - mean) / double(z.size());
        std::vector<float> taps;
        for (unsigned j = 0; j < 4; ++j)
            taps.push_back(math_f::agaa_depthTap(j, m.shift + m.sum / m.count,
                                                 std::sqrt(math_f::agaa_momentsVariance(m)), *low, *high));
        std::sort(taps.begin(), taps.end());
        const double quantiles[] = {-1.34, -0.45, 0.45, 1.34};
        for (size_t j = 0; j < 4; ++j) {
            ASSERT_GE(taps[j], *low);
            ASSERT_LE(taps[j], *high);
            const double expected =
                std::min(std::max(mean + quantiles[j] * std::sqrt(variance), double(*low)), double(*high));
            error.add(std::abs(double(taps[j]) - expected) / std::abs(double(*low)));
        }
    }
}

TEST(HardCase16_ReversedInfiniteDepth, FiniteAtDepthZero) {
    for (float d : {0.0f, FLT_TRUE_MIN, FLT_MIN, 1.0f}) {
        for (float nearPlane : {1e-3f, 0.1f, 10.0f}) {
            const float z = math_f::agaa_viewZFromDepth(d, 0.0f, nearPlane, 0);
            ASSERT_TRUE(std::isfinite(z)) << d;
            ASSERT_LT(z, 0.0f);
            if (d == 1.0f) {
                EXPECT_EQ(z, -nearPlane);
            }
            const glm::vec3 p = math_f::agaa_viewPosition({1, -1}, z, 0.5f, 0.5f, 0, 0, 0);
            ASSERT_TRUE(allFinite(p));
            ASSERT_TRUE(std::isfinite(glm::dot(p, p)));
            ASSERT_TRUE(std::isfinite(math_f::agaa_depthQuantum(z, d, 0.0f, nearPlane, 0, 6e-8f)));
        }
    }
    // The far value of the forward infinite projection.
    EXPECT_TRUE(std::isfinite(math_f::agaa_viewZFromDepth(1.0f, -1.0f, -0.1f, 0)));
}

TEST(HardCase18_ZeroCoverage, MeansAreZero) {
    EXPECT_EQ(math_f::agaa_meanOfSum(0, 0, 16), 0.0f);
    EXPECT_EQ(math_f::agaa_meanOfSum(12345, 0, 16), 0.0f);
    const math_f::agaa_Moments m = math_f::agaa_momentsInit(3.0f);
    EXPECT_EQ(math_f::agaa_momentsVariance(m), 0.0f);
}

TEST(HardCase19_OneSample, VarianceZeroAndRoughnessUnchanged) {
    Random random(219);
    for (int i = 0; i < 50000; ++i) {
        math_f::agaa_Moments m = math_f::agaa_momentsInit(random.rangeF(-1e4, 1e4));
        const float x = random.rangeF(-1e4, 1e4);
        math_f::agaa_momentsAdd(m, x);
        ASSERT_EQ(math_f::agaa_momentsVariance(m), 0.0f);
        const glm::vec3 n(random.direction());
        glm::vec3 d;
        float len;
        math_f::agaa_meanDirection(n, {0, 0, 1}, d, len);
        const float a = static_cast<float>(random.decades(4.2e-6, 1));
        const float kept = math_f::agaa_varianceFloor(len, math_f::agaa_storedLengthBound(1, 16));
        ASSERT_EQ(math_f::agaa_toksvigAlpha2(a, kept), a);
    }
}

TEST(HardCase20_DepthQuantum, StepsOfTheFormats) {
    const float nearPlane = 0.1f, farPlane = 10000.0f;
    const float p22 = farPlane / (nearPlane - farPlane), p32 = nearPlane * p22;
    auto step = [&](float z, float bits) {
        const float d = (p22 * z + p32) / -z;
        return math_f::agaa_depthQuantum(z, d, p22, p32, 0, std::exp2(-bits));
    };
    // z^2 / (near 2^bits): 10 cm at 410 m with 24 bits and at 25.6 m with 16.
    EXPECT_NEAR(step(-410.0f, 24), 0.1f, 0.01f);
    EXPECT_NEAR(step(-25.6f, 16), 0.1f, 0.002f);
    // A float depth, reversed: 6e-5 m at 1 km.
    const float d = nearPlane / 1000.0f;
    const float ulp = std::nextafter(d, 1.0f) - d;
    EXPECT_LT(math_f::agaa_depthQuantum(-1000.0f, d, 0.0f, nearPlane, 0, ulp), 1.3e-4f);
}

// The ids of n samples, stored and loaded again, select exactly the samples that have them.
static void expectPlanesRoundTrip(unsigned n, unsigned c, const std::vector<unsigned>& ids) {
    glm::uvec2 planes(0u);
    for (unsigned s = 0; s < n; ++s)
        math_f::agaa_putAggregateId(planes, s, ids[s]);
    const glm::uvec2 loaded = math_f::agaa_loadedPlanes(math_f::agaa_storedPlanes(planes, n, c), n, c);
    for (unsigned a = 0; a < c; ++a)
        for (unsigned s = 0; s < n; ++s)
            ASSERT_EQ(math_f::agaa_samplesOfAggregate(loaded, a) >> s & 1u, unsigned(ids[s] == a))
                << "n=" << n << " c=" << c << " sample " << s << " aggregate " << a;
}

TEST(HardCase29_IdsOfThreeAggregates, AllCountsRoundTrip) {
    for (unsigned c = 1; c <= 4; ++c) {
        for (unsigned n : {1u, 2u, 4u, 8u, 16u, 32u}) {
            Random random(229 + c);
            for (int trial = 0; trial < 200; ++trial) {
                std::vector<unsigned> ids(n);
                for (unsigned& id : ids)
                    id = random.below(c);
                expectPlanesRoundTrip(n, c, ids);
            }
        }
    }
}

TEST(HardCase30_SixtyFourBitsOfMetadata, LastSampleLastAggregate) {
    glm::uvec2 planes(0u);
    math_f::agaa_putAggregateId(planes, 31, 3);
    EXPECT_EQ(planes, glm::uvec2(0x80000000u, 0x80000000u));
    EXPECT_EQ(math_f::agaa_storedPlanes(planes, 32, 4), planes);
    EXPECT_EQ(math_f::agaa_samplesOfAggregate(planes, 3), 0x80000000u);
    EXPECT_EQ(math_f::agaa_samplesOfAggregate(planes, 0), 0x7FFFFFFFu);
}

TEST(HardCase31_RoundingOfSums, MeanOfCodesWithinHalfACode) {
    Random random(231);
    for (unsigned bits : {8u, 10u, 11u, 16u}) {
        Worst error("mean of n codes, bits " + std::to_string(bits) + ": error in codes", 0.51);
        for (int i = 0; i < 20000; ++i) {
            const unsigned n = 1 + random.below(32);
            unsigned sum = 0;
            double mean = 0.0;
            for (unsigned s = 0; s < n; ++s) {
                const float v = random.rangeF(0, 1);
                sum += math_f::agaa_quantise(v, bits);
                mean += double(v) / n;
            }
            error.add(std::abs(double(math_f::agaa_meanOfSum(sum, n, bits)) - mean) * math_f::agaa_maxCode(bits));
        }
    }
}

TEST(HardCase33_Saturation, WhiteStaysExactlyWhite) {
    for (unsigned bits = 1; bits <= 16; ++bits) {
        for (unsigned n = 1; n <= 32; ++n) {
            EXPECT_EQ(math_f::agaa_meanOfSum(n * math_f::agaa_quantise(1.0f, bits), n, bits), 1.0f);
        }
    }
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

TEST(HardCase56_FoldedGuards, SurviveFastMath) {
    volatile float source[] = {nanF(), infinityF(), -infinityF()};
    for (volatile float& v : source) {
        const float x = v;
        unsigned flag = 0;
        EXPECT_FALSE(fastMathIsFinite(x));
        EXPECT_EQ(fastMathSanitise(x, 0.0f, 1.0f, flag), 0.0f);
        EXPECT_EQ(flag, 1u);
    }
    std::printf("[ measured ] x == x of a NaN under -ffast-math: %s\n",
                fastMathComparesEqualToItself(source[0]) ? "folded to true" : "kept");
    EXPECT_TRUE(fastMathIsFinite(1.0f));
}
