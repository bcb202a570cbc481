// Encodings and guards: float against double, and the error the stored bits leave.
#include "test_support.h"

using namespace test_math;

TEST(MathEncoding, ViewBasisIsOrthonormal) {
    Random random(1);
    Worst dots("view basis: |dot| and |length-1|", 6e-7);
    Worst toDouble("view basis: float against double", 3e-7);
    Worst handed("view basis: cross(t,b) against v", 6e-7);
    for (int i = 0; i < 200000; ++i) {
        glm::vec3 v(random.direction());
        if (i % 4 == 1) {
            // Around the pole at which the usual construction divides by zero.
            const double e = random.decades(1e-12, 1e-2);
            v = glm::vec3(glm::normalize(glm::dvec3(e * random.range(-1, 1), e, -1.0)));
        }
        if (i == 0)
            v = {0, 0, -1};
        if (i == 4)
            v = {0, 0, 1};
        if (i == 8)
            v = {0, 0, -0.0f};
        if (i == 8)
            v.x = 1;
        glm::vec3 t, b;
        math_f::agaa_viewBasis(v, t, b);
        dots.add(std::abs(glm::dot(t, b)));
        dots.add(std::abs(glm::dot(t, v)));
        dots.add(std::abs(glm::dot(b, v)));
        dots.add(std::abs(glm::length(t) - 1.0f));
        dots.add(std::abs(glm::length(b) - 1.0f));
        handed.add(glm::length(glm::cross(t, b) - v));
        glm::dvec3 td, bd;
        math_d::agaa_viewBasis(glm::dvec3(v), td, bd);
        toDouble.add(glm::length(glm::dvec3(t) - td));
        toDouble.add(glm::length(glm::dvec3(b) - bd));
    }
}

TEST(MathEncoding, HemiOctErrorAndFloatAgainstDouble) {
    Random random(2);
    Worst angle("hemi-octahedral 2x8 bit: degrees", 0.55);
    Worst codes("hemi-octahedral: float and double codes differ by", 1.0);
    int different = 0;
    const int count = 300000;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 n = random.hemisphere();
        const glm::uvec2 code = math_f::agaa_encodeHemiOct8(glm::vec3(n));
        const glm::uvec2 codeD = math_d::agaa_encodeHemiOct8(glm::dvec3(glm::vec3(n)));
        ASSERT_GE(std::min(code.x, code.y), 1u);
        ASSERT_LE(std::max(code.x, code.y), 255u);
        different += code != codeD;
        codes.absolute(code.x, codeD.x);
        codes.absolute(code.y, codeD.y);
        const double e = degreesBetween(glm::dvec3(math_f::agaa_decodeHemiOct8(code)), n);
        angle.add(e);
        sum += e;
    }
    std::printf("[ measured ] hemi-oct mean %.3f degrees; codes differ in %d of %d\n", sum / count, different, count);
    EXPECT_LT(different, count / 5000);
}

TEST(MathEncoding, MeansOfNeighbouringHemiOctCodesAreWithinTheBound) {
    double most = 0;
    for (unsigned x = 1; x < 255; ++x)
        for (unsigned y = 1; y < 255; ++y)
            for (const glm::uvec2 other :
                 {glm::uvec2(x + 1, y), glm::uvec2(x, y + 1), glm::uvec2(x + 1, y + 1), glm::uvec2(x + 1, y - 1)})
                most = std::max(most, 1 - glm::length(0.5 * (math_d::agaa_decodeHemiOct8({x, y}) +
                                                             math_d::agaa_decodeHemiOct8(other))));
    std::printf("[ measured ] mean of neighbouring codes is shorter by %.3g\n", most);
    EXPECT_LE(most, double(math_f::agaa_hemiOct8LengthBound()));
    EXPECT_GT(most, 0.95 * double(math_f::agaa_hemiOct8LengthBound()));
}

TEST(MathEncoding, HemiOctProjectsBelowTheHorizon) {
    Random random(3);
    Worst azimuth("normals below the horizon: azimuth error in degrees", 0.65);
    for (int i = 0; i < 50000; ++i) {
        glm::dvec3 n = random.hemisphere(0.01);
        n.z = -n.z * 0.9;
        n = glm::normalize(n);
        const glm::vec3 d = math_f::agaa_decodeHemiOct8(math_f::agaa_encodeHemiOct8(glm::vec3(n)));
        if (std::abs(n.z) < 0.99) {
            azimuth.add(degreesBetween(glm::normalize(glm::dvec3(n.x, n.y, 0)), glm::dvec3(d)));
        }
    }
    EXPECT_EQ(math_f::agaa_encodeHemiOct8({0, 0, -1}), glm::uvec2(128, 128));
}

TEST(MathEncoding, OctErrorPerBits) {
    struct Row {
        unsigned bits;
        double bound;
    };
    for (const Row& row : {Row{8, 0.95}, Row{10, 0.235}, Row{11, 0.119}, Row{16, 0.0037}}) {
        Random random(4);
        Worst angle("octahedral, bits " + std::to_string(row.bits) + ": degrees", row.bound);
        const double top = (1u << row.bits) - 1u;
        for (int i = 0; i < 150000; ++i) {
            const glm::dvec3 n = random.direction();
            const glm::dvec2 u(math_f::agaa_encodeOct(glm::vec3(n), row.bits));
            ASSERT_GT(u.x * top, 0.99);
            ASSERT_LE(u.x, 1.0);
            ASSERT_GT(u.y * top, 0.99);
            ASSERT_LE(u.y, 1.0);
            // What a UNORM channel does to it: round to the nearest code.
            const glm::vec2 stored(std::floor(u.x * top + 0.5) / top, std::floor(u.y * top + 0.5) / top);
            angle.add(degreesBetween(glm::dvec3(math_f::agaa_decodeOct(stored, row.bits)), n));
        }
    }
}

TEST(MathEncoding, OctIsExactOnTheAxes) {
    for (unsigned bits : {8u, 10u, 16u}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (float sign : {-1.0f, 1.0f}) {
                glm::vec3 n(0);
                n[axis] = sign;
                EXPECT_EQ(math_f::agaa_decodeOct(math_f::agaa_encodeOct(n, bits), bits), n)
                    << bits << " " << axis << " " << sign;
            }
        }
    }
}

TEST(MathEncoding, QuantiseRoundsToNearest) {
    Random random(5);
    for (unsigned bits = 1; bits <= 16; ++bits) {
        const double top = (1u << bits) - 1u;
        Worst error("quantise, bits " + std::to_string(bits) + ": error in codes", 0.5 + 0.005);
        for (int i = 0; i < 20000; ++i) {
            const float v = random.rangeF(0, 1);
            error.absolute(math_f::agaa_quantise(v, bits), double(v) * top);
            ASSERT_LE(std::abs(int(math_f::agaa_quantise(v, bits)) - int(math_d::agaa_quantise(double(v), bits))), 1);
        }
        for (unsigned code = 0; code <= unsigned(top); code += 1 + unsigned(top) / 1000) {
            ASSERT_EQ(math_f::agaa_quantise(float(code / top), bits), code);
        }
        EXPECT_EQ(math_f::agaa_quantise(2.0f, bits), unsigned(top));
        EXPECT_EQ(math_f::agaa_quantise(-0.023f, bits), 0u);
        EXPECT_EQ(math_f::agaa_quantise(nanF(), bits), 0u);
        EXPECT_EQ(math_f::agaa_quantise(infinityF(), bits), 0u);
    }
    for (unsigned bits = 17; bits <= 24; ++bits) {
        EXPECT_EQ(math_f::agaa_quantise(1.0f, bits), (1u << bits) - 1u);
    }
}

TEST(MathEncoding, MeanOfSum) {
    Random random(6);
    Worst error("mean of sum: float against double, relative", 1.3e-7);
    for (int i = 0; i < 100000; ++i) {
        const unsigned bits = 1 + random.below(16);
        const unsigned count = 1 + random.below(32);
        const unsigned sum = random.below(count * ((1u << bits) - 1u)) + 1u;
        error.relative(math_f::agaa_meanOfSum(sum, count, bits), math_d::agaa_meanOfSum(sum, count, bits));
    }
    EXPECT_EQ(math_f::agaa_meanOfSum(17, 0, 8), 0.0f);
}

TEST(MathEncoding, YCbCrRoundTrip) {
    Random random(7);
    Worst trip("YCbCr round trip in float: absolute", 5e-7);
    Worst toDouble("YCbCr: float against double", 2e-7);
    Worst range("YCbCr of [0,1] colours: distance outside [0,1]", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        glm::vec3 c(random.unit(), random.unit(), random.unit());
        if (i < 8)
            c = {i & 1 ? 1 : 0, i & 2 ? 1 : 0, i & 4 ? 1 : 0};
        const glm::vec3 y = math_f::agaa_rgbToYCbCr(c);
        const glm::vec3 back = math_f::agaa_yCbCrToRgb(y);
        const glm::dvec3 d = math_d::agaa_rgbToYCbCr(glm::dvec3(c));
        for (int k = 0; k < 3; ++k) {
            trip.absolute(back[k], c[k]);
            toDouble.absolute(y[k], d[k]);
            range.add(std::max(-double(y[k]), double(y[k]) - 1.0));
        }
    }
}

TEST(MathEncoding, SignedMeanOfSum) {
    Random random(8);
    for (unsigned bits = 6; bits <= 16; ++bits) {
        Worst error("mean of signed codes, bits " + std::to_string(bits) + ": error in codes", 0.51);
        const double step = 2.0 / ((1u << bits) - 2u);
        for (int i = 0; i < 5000; ++i) {
            const unsigned n = 1 + random.below(32);
            unsigned sum = 0;
            double mean = 0;
            for (unsigned s = 0; s < n; ++s) {
                const float v = random.rangeF(-1, 1);
                sum += math_f::agaa_signedCode(v, bits);
                mean += double(v) / n;
            }
            error.add(std::abs(double(math_f::agaa_signedMeanOfSum(sum, n, bits)) - mean) / step);
        }
        for (unsigned n = 1; n <= 32; ++n)
            for (const float exact : {-1.0f, 0.0f, 1.0f})
                EXPECT_EQ(math_f::agaa_signedMeanOfSum(n * math_f::agaa_signedCode(exact, bits), n, bits), exact);
    }
    EXPECT_EQ(math_f::agaa_signedMeanOfSum(17, 0, 11), 0.0f);
}

TEST(MathEncoding, DegenerateNormalsGiveTheCodeOfZ) {
    const std::vector<glm::vec3> bad = {{0, 0, 0}, {1e-40f, 0, 0}, {nanF(), 0, 1}, {0, infinityF(), 0}};
    for (const glm::vec3& n : bad) {
        EXPECT_EQ(math_f::agaa_encodeHemiOct8(n), glm::uvec2(128, 128));
        EXPECT_EQ(math_f::agaa_decodeOct(math_f::agaa_encodeOct(n, 10), 10), glm::vec3(0, 0, 1));
    }
    for (float a : extremeFloats()) {
        for (float b : extremeFloats()) {
            const glm::vec3 d = math_f::agaa_decodeHemiOct8(math_f::agaa_encodeHemiOct8({a, b, a}));
            const glm::vec3 o = math_f::agaa_decodeOct(math_f::agaa_encodeOct({a, b, b}, 16), 16);
            ASSERT_NEAR(glm::length(d), 1.0f, 1e-6f) << a << " " << b;
            ASSERT_NEAR(glm::length(o), 1.0f, 1e-6f) << a << " " << b;
        }
    }
}
