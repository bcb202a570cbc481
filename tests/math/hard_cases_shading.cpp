// Hard cases of normal distributions, lobes and lights; the numbers are those of the list of
// numerically hard cases.
#include <cfloat>

#include "test_support.h"

using namespace test_math;

namespace {

// The five steps of section 3.5.2 as printed, in double, for arguments where they are defined.
double paperToksvig(double alpha2, double len) {
    const double s = 2.0 / alpha2 - 2.0;
    const double factor = len / (len + s * (1.0 - len));
    return 2.0 / (factor * s + 2.0);
}

std::vector<float> unitGrid() {
    std::vector<float> v = {0.0f, FLT_TRUE_MIN, 1e-40f, FLT_MIN, 1e-20f, 1e-10f, 1e-7f, 1e-5f};
    for (int i = 1; i < 200; ++i)
        v.push_back(static_cast<float>(i) / 200.0f);
    for (float e : {1e-3f, 1e-4f, 1e-5f, 1e-6f, FLT_EPSILON, FLT_EPSILON / 2})
        v.push_back(1.0f - e);
    v.push_back(1.0f);
    return v;
}

} // namespace

TEST(HardCase01_ToksvigZeroRoughness, FiniteBoundedAndMonotone) {
    std::vector<float> grid = unitGrid();
    std::sort(grid.begin(), grid.end());
    // Monotone up to the rounding of one division.
    const float slack = 2.0f * FLT_EPSILON;
    for (float a : grid) {
        float previous = 2.0f;
        for (float len : grid) {
            const float w = math_f::agaa_toksvigAlpha2(a, len);
            ASSERT_TRUE(std::isfinite(w));
            ASSERT_GE(w, a);
            ASSERT_LE(w, 1.0f);
            ASSERT_LE(w, previous * (1.0f + slack)) << a << " " << len;
            previous = w;
        }
    }
    for (float len : grid) {
        float previous = 0.0f;
        for (float a : grid) {
            const float w = math_f::agaa_toksvigAlpha2(a, len);
            ASSERT_GE(w, previous * (1.0f - slack)) << a << " " << len;
            previous = w;
        }
    }
    EXPECT_EQ(math_f::agaa_toksvigAlpha2(0.0f, 1.0f), 0.0f);
    EXPECT_EQ(math_f::agaa_toksvigAlpha2(0.0f, 0.0f), 1.0f);
}

TEST(HardCase01_ToksvigZeroRoughness, EqualsThePaperInDouble) {
    Random random(101);
    Worst error("toksvig against the paper's five steps in double, r >= .02", 5e-5);
    for (int i = 0; i < 200000; ++i) {
        const float r = random.rangeF(0.02, 1);
        const float a = r * r;
        const float len = i % 2 ? random.rangeF(1e-3, 1) : 1.0f - float(random.decades(1e-7, 0.1));
        error.relative(math_f::agaa_toksvigAlpha2(a, len), paperToksvig(a, len));
    }
}

TEST(HardCase02_MeanLengthAboveOne, NeighboursOfStoredUnitNormals) {
    Random random(102);
    for (unsigned bits : {8u, 10u, 16u}) {
        for (int i = 0; i < 3000; ++i) {
            const glm::vec3 n(random.direction());
            for (int k = 0; k < 27; ++k) {
                const glm::ivec3 offset(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
                glm::vec3 stored;
                for (int c = 0; c < 3; ++c) {
                    const unsigned code = math_f::agaa_signedCode(n[c], bits) + unsigned(offset[c]);
                    stored[c] = math_f::agaa_signedMeanOfSum(code, 1, bits);
                }
                glm::vec3 direction;
                float len;
                math_f::agaa_meanDirection(stored, {0, 0, 1}, direction, len);
                ASSERT_LE(len, 1.0f);
                for (float r : {0.0f, 0.005f, 0.01f, 0.045f}) {
                    const float w = math_f::agaa_toksvigAlpha2(r * r, len);
                    ASSERT_TRUE(std::isfinite(w) && w >= r * r && w <= 1.0f);
                }
            }
        }
    }
    for (float len : {1.000205f, 1.00083f, 2.0f, FLT_MAX}) {
        EXPECT_EQ(math_f::agaa_toksvigAlpha2(0.0001f, len), 0.0001f);
    }
}

TEST(HardCase03_RoughnessOutOfRange, Clamped) {
    for (float r : {1.0f, std::nextafter(1.0f, 2.0f), 1.1f, 65504.0f, -1.0f}) {
        for (float len : {0.0f, FLT_TRUE_MIN, 0.5f, 1.0f, 1.5f}) {
            const float w = math_f::agaa_toksvigAlpha2(r * r, len);
            EXPECT_EQ(w, 1.0f) << r << " " << len;
            const float s = math_f::agaa_exponentFromAlpha2(r * r);
            EXPECT_EQ(s, 0.0f) << r;
        }
    }
    EXPECT_TRUE(std::isfinite(math_f::agaa_toksvigAlpha2(-1.0f, 0.5f)));
}

TEST(HardCase04_OppositeNormalsCancel, FiniteAndEnergyAtMostOne) {
    Random random(104);
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 n(random.direction());
        glm::vec3 m = -n;
        if (i % 3) {
            const int axis = i % 2 + i % 3 - 1;
            m[axis] = std::nextafter(m[axis], i % 5 ? 2.0f : -2.0f);
        }
        glm::vec3 direction;
        float len;
        math_f::agaa_meanDirection((n + m) * 0.5f, n, direction, len);
        ASSERT_EQ(len, 0.0f);
        ASSERT_NEAR(glm::length(direction), 1.0f, 1e-6f);
        ASSERT_GT(glm::dot(direction, n), 0.99999f);
        const float w = math_f::agaa_toksvigAlpha2(0.01f, len);
        ASSERT_EQ(w, 1.0f);
        math_f::agaa_Surface s{};
        s.diffuse = s.specular = glm::vec3(1);
        s.emissive = glm::vec3(0);
        s.normal = direction;
        s.meanLength = len;
        s.alpha2 = w;
        const glm::vec3 c = math_f::agaa_shade(s, n, glm::vec3(random.direction()), i & 1, 1, 0);
        ASSERT_TRUE(allFinite(c));
        ASSERT_LE(c.x, 1.0f);
    }
}

TEST(HardCase05_QuantisedVarianceFloor, FlatMirrorStaysAMirror) {
    Random random(105);
    for (unsigned bits : {10u, 16u}) {
        const double span = (math_f::agaa_maxCode(bits) - 1) / 2;
        for (unsigned n : {8u, 32u}) {
            double raised = 0.0, untreated = 0.0;
            for (int i = 0; i < 3000; ++i) {
                const glm::vec3 normal(random.direction());
                // Exact integer sums, and a blender that rounds after every addition of code/n.
                glm::uvec3 exact(0);
                glm::dvec3 blended(0);
                for (unsigned s = 0; s < n; ++s) {
                    for (int c = 0; c < 3; ++c) {
                        exact[c] += math_f::agaa_signedCode(normal[c], bits);
                        blended[c] += std::floor((double(normal[c]) + 1) / n * span + random.unit());
                    }
                }
                const glm::vec3 meanE(math_f::agaa_signedMeanOfSum(exact.x, n, bits),
                                      math_f::agaa_signedMeanOfSum(exact.y, n, bits),
                                      math_f::agaa_signedMeanOfSum(exact.z, n, bits));
                const glm::vec3 meanB(blended / span - 1.0);
                glm::vec3 d;
                float len;
                const float a = math_f::agaa_minAlpha2();
                math_f::agaa_meanDirection(meanE, normal, d, len);
                float kept = math_f::agaa_varianceFloor(len, math_f::agaa_storedLengthBound(1, bits));
                ASSERT_EQ(kept, 1.0f) << bits << " " << n;
                math_f::agaa_meanDirection(meanB, normal, d, len);
                untreated = std::max(untreated, double(math_f::agaa_toksvigAlpha2(a, len)));
                // Rounding up and down by up to a whole code: twice the bound of rounding to
                // nearest.
                kept = math_f::agaa_varianceFloor(len, math_f::agaa_storedLengthBound(2 * n, bits));
                raised = std::max(raised, double(math_f::agaa_toksvigAlpha2(a, kept)));
            }
            std::printf("[ measured ] mirror, RGB%u, n=%u: alpha %.4f, without the floor %.4f\n", bits, n,
                        std::sqrt(raised), std::sqrt(untreated));
            EXPECT_EQ(static_cast<float>(raised), math_f::agaa_minAlpha2());
        }
    }
}

TEST(HardCase05_QuantisedVarianceFloor, ContinuousAndMonotone) {
    const float bound = math_f::agaa_storedLengthBound(8, 10);
    float previous = math_f::agaa_varianceFloor(0.0f, bound);
    EXPECT_EQ(previous, 0.0f);
    EXPECT_EQ(math_f::agaa_varianceFloor(1.0f, bound), 1.0f);
    Worst jump("varianceFloor: change per change of length, minus 1", 0.03);
    const int steps = 20000;
    for (int i = 1; i <= steps; ++i) {
        const float len = static_cast<float>(i) / steps;
        const float now = math_f::agaa_varianceFloor(len, bound);
        ASSERT_GE(now, previous);
        jump.add(double(now - previous) * steps - 1.0);
        previous = now;
    }
}

TEST(HardCase08_GgxTinyAlpha, CrossFormAgainstDouble) {
    Random random(108);
    Worst error("ggxD from float vectors against double, alpha .002025..1", 1e-3);
    double textbook = 0.0;
    for (int i = 0; i < 300000; ++i) {
        const double alpha = random.decades(0.002025, 1.0);
        const float a2 = std::max(float(alpha * alpha), math_f::agaa_minAlpha2());
        const glm::dvec3 nd = random.direction();
        const glm::vec3 n(nd);
        const glm::vec3 h(glm::normalize(nd + alpha * random.range(0.1, 3) * random.direction()));
        const glm::vec3 c = glm::cross(n, h);
        const glm::dvec3 cd = glm::cross(glm::dvec3(n), glm::dvec3(h));
        const double reference = math_d::agaa_ggxD(a2, glm::dot(glm::dvec3(n), glm::dvec3(h)), glm::dot(cd, cd));
        const float noH = glm::dot(n, h);
        error.relative(math_f::agaa_ggxD(a2, noH, glm::dot(c, c)), reference);
        const float plain = a2 / (math_f::agaa_pi() * math_f::agaa_sq(noH * noH * (a2 - 1.0f) + 1.0f));
        textbook = std::max(textbook, std::abs(double(plain) - reference) / reference);
    }
    std::printf("[ measured ] textbook form on the same vectors: relative error %.3g\n", textbook);
    EXPECT_GT(textbook, 100.0 * error.value());
    for (float a : {0.0f, -1.0f, FLT_TRUE_MIN, 1e-12f}) {
        const float d = math_f::agaa_ggxD(a, 1.0f, 0.0f);
        EXPECT_NEAR(d, 1.0f / (3.14159265f * 4.100625e-6f), 1.0f) << a;
    }
}

TEST(HardCase09_RoughnessConventions, RoundTripIsTheIdentity) {
    Worst ulps("alpha2 -> exponent -> alpha2 at length 1: units in the last place", 2.0);
    Random random(109);
    for (int i = 0; i < 200000; ++i) {
        const float a = static_cast<float>(i % 2 ? random.decades(4.2e-6, 1) : random.range(1e-5, 1));
        const float s = math_f::agaa_exponentFromAlpha2(a);
        const float back = math_f::agaa_toksvigAlpha2(2.0f / (s + 2.0f), 1.0f);
        ulps.add(std::abs(double(back) - double(a)) / double(std::nextafter(a, 2.0f) - a));
    }
    // s = 2/alpha2 - 2.
    EXPECT_NEAR(math_f::agaa_exponentFromAlpha2(0.0625f), 30.0f, 1e-5f);
}

TEST(HardCase12_FlippedNormals, SignedProductCounts) {
    EXPECT_NEAR(math_f::agaa_normalMetric(-1.0f), std::sqrt(2.0f), 1e-6f);
    EXPECT_EQ(math_f::agaa_normalMetric(1.0f), 0.0f);
    // Distances see the flip as well: two opposite normals at one place are two aggregates.
    math_f::Clustering c{};
    c.agaa_samplePosition[0] = c.agaa_samplePosition[1] = {0, 0, -5};
    c.agaa_sampleNormal[0] = {0, 0, 1};
    c.agaa_sampleNormal[1] = {0, 0, -1};
    for (unsigned i : {0u, 1u}) {
        c.agaa_sampleKeyA[i] = 7;
        c.agaa_sampleKeyB[i] = i;
    }
    EXPECT_EQ(c.agaa_defineAggregates(2, 3, 2, 0.1f, 0.02f, 0), 2u);
}

TEST(HardCase13_ProductAboveOne, NoNaN) {
    Random random(113);
    int above = 0;
    const int count = 100000;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 n(random.direction());
        const float d = glm::dot(n, n);
        above += d > 1.0f;
        ASSERT_TRUE(std::isfinite(math_f::agaa_normalMetric(d)));
        ASSERT_LE(math_f::agaa_normalMetric(d), 5e-4f);
    }
    std::printf("[ measured ] n.n above 1 for %.1f %% of rounded unit vectors\n", 100.0 * above / count);
    EXPECT_GT(above, 0);
}

TEST(HardCase39_LightAtTheSurface, FiniteAtDistanceZero) {
    for (float range : {0.0f, 1e-30f, 1.0f, 100.0f, FLT_MAX}) {
        for (float rMin2 : {0.0f, 1e-4f, 1.0f}) {
            for (float d2 : {0.0f, FLT_TRUE_MIN, 1e-20f, 1.0f, FLT_MAX}) {
                const float a = math_f::agaa_pointAttenuation(d2, range, rMin2);
                ASSERT_TRUE(std::isfinite(a) && a >= 0.0f) << range << " " << rMin2 << " " << d2;
            }
        }
    }
    EXPECT_EQ(math_f::agaa_lightDirection({0, 0, 0}, 1e-4f), glm::vec3(0));
    EXPECT_EQ(math_f::agaa_pointAttenuation(0.0f, 10.0f, 0.25f), 4.0f);
    Worst step("attenuation: step at the end of the range", 1e-6);
    step.add(math_f::agaa_pointAttenuation(math_f::agaa_sq(99.99f), 100.0f, 1e-4f));
}

TEST(HardCase40_EqualSpotCones, StepWithoutNaN) {
    for (float c : {-1.0f, 0.0f, 0.5f, 1.0f}) {
        for (float x : {-1.0f, 0.0f, 0.5f, 1.0f}) {
            const float v = math_f::agaa_spotCone(x, c, c);
            ASSERT_TRUE(v >= 0.0f && v <= 1.0f) << c << " " << x;
            if (x > c + 1e-3f) {
                EXPECT_EQ(v, 1.0f);
            }
            if (x <= c) {
                EXPECT_EQ(v, 0.0f);
            }
        }
    }
    // Swapped cones are a step too, not a negative light.
    EXPECT_EQ(math_f::agaa_spotCone(0.9f, 0.5f, 0.8f), 1.0f);
    EXPECT_EQ(math_f::agaa_spotCone(0.7f, 0.5f, 0.8f), 0.0f);
}

TEST(HardCase58_BlinnPhongHighExponents, AgainstDouble) {
    Random random(158);
    Worst near("Blinn-Phong, s 1..1e6, h within 1e-4 of n: relative", 2e-6);
    Worst wide("Blinn-Phong, s 1..1e6, the whole lobe: relative", 5e-5);
    double power = 0.0;
    for (int i = 0; i < 200000; ++i) {
        const float s = static_cast<float>(random.decades(1, 1e6));
        const double angle =
            i % 2 ? random.decades(1e-8, 1e-4) : std::min(1.5, random.range(0, 4) / std::sqrt(double(s)));
        const float sin2 = static_cast<float>(std::sin(angle) * std::sin(angle));
        const float cosine = static_cast<float>(std::cos(angle));
        // The cosine that belongs to the sine given: the reference must not see another angle.
        const double logCosine = sin2 < 0.5f ? 0.5 * std::log1p(-double(sin2)) : std::log(double(cosine));
        const double reference = (double(s) + 2.0) / 6.283185307179586 * std::exp(double(s) * logCosine);
        (i % 2 ? near : wide).relative(math_f::agaa_blinnPhong(s, sin2, cosine), reference);
        const double plain = (double(s) + 2.0) / 6.283185307179586 * double(std::pow(cosine, s));
        power = std::max(power, std::abs(plain - reference) / reference);
    }
    std::printf("[ measured ] pow(n.h, s) on the same angles: relative error %.3g\n", power);
    EXPECT_GT(power, 1e-2);
    for (float s : extremeFloats()) {
        for (float x : extremeFloats()) {
            if (s > 1e30f)
                continue;
            const float d = math_f::agaa_blinnPhong(s, x, 0.5f);
            ASSERT_TRUE(std::isfinite(d) && d >= 0.0f) << s << " " << x;
        }
    }
    EXPECT_EQ(math_f::agaa_blinnPhong(10.0f, 1.0f, 0.0f), 0.0f);
}
