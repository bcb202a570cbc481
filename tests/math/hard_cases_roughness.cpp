// Hard cases 1 to 5 and 9 of docs/numerics.md: the widening of a lobe by the length of a mean normal.
#include <cfloat>

#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

namespace {

// The five steps of section 3.5.2 as printed. They return the square of the paper's roughness.
template <class T> T printedToksvig(T r, T len) {
    const T s = T(2) / (r * r) - T(2);
    const T factor = len / (len + s * (T(1) - len));
    return T(2) / (factor * s + T(2));
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

// The mean of n equal normals whose codes were rounded up or down in each addition.
glm::vec3 blendedMean(Random& random, const glm::vec3& normal, unsigned n, unsigned bits) {
    const double span = (math_f::agaa_maxCode(bits) - 1) / 2;
    glm::dvec3 sum(0);
    for (unsigned s = 0; s < n; ++s)
        for (int c = 0; c < 3; ++c)
            sum[c] += std::floor((double(normal[c]) + 1) / n * span + random.unit());
    return glm::vec3(sum / span - 1.0);
}

} // namespace

TEST(HardCase01_ToksvigZeroRoughness, PrintedStepsAreNotFinite) {
    Random random(101);
    HardCaseFigures figures(1, "relative error of the widened alpha²", 5e-5);
    for (int i = 0; i < 200000; ++i) {
        const float r = i % 8 == 0 ? 0.0f : i % 2 ? random.rangeF(0.02, 1) : float(random.decades(1e-4, 1));
        const float a = r * r;
        const float len = i % 3 ? random.rangeF(1e-3, 1) : 1.0f - float(random.decades(1e-7, 0.1));
        const double reference = math_d::agaa_toksvigAlpha2(a, len);
        if (r >= 0.02f) {
            ASSERT_NEAR(reference, printedToksvig(std::sqrt(double(a)), double(len)), 1e-9 * reference);
        }
        figures.relative(double(printedToksvig(r, len)), double(math_f::agaa_toksvigAlpha2(a, len)), reference);
    }
    // At r = 0 the printed steps return NaN for every length.
    for (float len : unitGrid())
        EXPECT_TRUE(std::isnan(printedToksvig(0.0f, len))) << len;
}

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

TEST(HardCase02_MeanLengthAboveOne, SumsOfRoundedNormals) {
    Random random(102);
    HardCaseFigures figures(2, "relative error of the widened roughness", 1e-6);
    double longest = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = i % 2 ? 8 : 32;
        const glm::vec3 mean = blendedMean(random, glm::vec3(random.direction()), n, 16);
        const float len = glm::length(mean), r = float(random.decades(0.001, 1));
        longest = std::max(longest, double(len));
        const double reference = std::sqrt(math_d::agaa_toksvigAlpha2(double(r) * double(r), double(len)));
        figures.relative(double(std::sqrt(printedToksvig(r, len))),
                         double(std::sqrt(math_f::agaa_toksvigAlpha2(r * r, len))), reference);
    }
    EXPECT_GT(longest, 1.0002);
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
    Random random(103);
    HardCaseFigures figures(3, "error of the widened alpha²", 0.0);
    const float listed[] = {1.0f, std::nextafter(1.0f, 2.0f), 1.1f, 65504.0f, -1.0f};
    for (int i = 0; i < 100000; ++i) {
        const float r = i < 25 ? listed[i % 5] : float(random.decades(1, 65504));
        const float len = i < 25 ? float(i / 5) * 0.25f : random.rangeF(0, 1);
        figures.add(std::abs(double(printedToksvig(r, len)) - 1.0),
                    std::abs(double(math_f::agaa_toksvigAlpha2(r * r, len)) - 1.0));
        ASSERT_EQ(math_f::agaa_exponentFromAlpha2(r * r), 0.0f) << r;
    }
    EXPECT_TRUE(std::isnan(printedToksvig(1.0f, 0.0f)));
    EXPECT_NEAR(std::sqrt(printedToksvig(1.1f, 0.5f)), 1.167, 0.1);
    EXPECT_TRUE(std::isfinite(math_f::agaa_toksvigAlpha2(-1.0f, 0.5f)));
}

TEST(HardCase04_OppositeNormalsCancel, FiniteDirection) {
    Random random(104);
    HardCaseFigures figures(4, "error of the mean direction's length", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 n(random.direction());
        glm::vec3 m = -n;
        if (i % 3) {
            const int axis = i % 2 + i % 3 - 1;
            m[axis] = std::nextafter(m[axis], i % 5 ? 2.0f : -2.0f);
        }
        const glm::vec3 mean = (n + m) * 0.5f;
        glm::vec3 direction;
        float len;
        math_f::agaa_meanDirection(mean, n, direction, len);
        ASSERT_EQ(len, 0.0f);
        ASSERT_GT(glm::dot(direction, n), 0.99999f);
        ASSERT_EQ(math_f::agaa_toksvigAlpha2(0.01f, len), 1.0f);
        figures.add(std::abs(double(glm::length(mean / glm::length(mean))) - 1.0),
                    std::abs(double(glm::length(direction)) - 1.0));
    }
}

// The reflectance of the whole hemisphere, by the directions of a grid of equal areas.
static double albedoOf(const math_f::agaa_Surface& s, const glm::vec3& v, unsigned brdf) {
    const int rows = 24, columns = 48;
    glm::vec3 t, b;
    math_f::agaa_viewBasis(s.normal, t, b);
    double sum = 0.0;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < columns; ++k) {
            const double z = (i + 0.5) / rows, phi = (k + 0.5) / columns * 6.283185307179586;
            const double r = std::sqrt(1 - z * z);
            const glm::vec3 l = float(r * std::cos(phi)) * t + float(r * std::sin(phi)) * b + float(z) * s.normal;
            const glm::vec3 c = math_f::agaa_shade(s, v, l, brdf, 1, 0);
            EXPECT_TRUE(allFinite(c));
            sum += double(c.x) * 6.283185307179586 / (rows * columns);
        }
    return sum;
}

TEST(HardCase04_OppositeNormalsCancel, EnergyAtMostOne) {
    Random random(1104);
    Worst energy("reflected share of the light of cancelled normals", 1.001);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 n(random.direction());
        glm::vec3 m = -n;
        if (i % 3)
            m[i % 3 - 1] = std::nextafter(m[i % 3 - 1], i % 2 ? 2.0f : -2.0f);
        math_f::agaa_Surface s{};
        math_f::agaa_meanDirection((n + m) * 0.5f, n, s.normal, s.meanLength);
        s.alpha2 = math_f::agaa_toksvigAlpha2(0.01f, s.meanLength);
        // The two terms alone: the host chooses materials whose sum is at most 1.
        (i % 4 < 2 ? s.diffuse : s.specular) = glm::vec3(1);
        glm::vec3 v(random.direction());
        if (glm::dot(v, s.normal) < 0)
            v = -v;
        energy.add(albedoOf(s, v, i & 1));
    }
}

TEST(HardCase05_QuantisedVarianceFloor, FlatMirrorStaysAMirror) {
    Random random(105);
    HardCaseFigures figures(5, "alpha of a mirror above its own", 1e-6);
    const double mirror = std::sqrt(double(math_f::agaa_minAlpha2()));
    for (unsigned bits : {8u, 10u, 16u})
        for (unsigned n : {8u, 32u}) {
            double untreated = 0.0;
            for (int i = 0; i < 17000; ++i) {
                const glm::vec3 normal(random.direction());
                const float a = math_f::agaa_minAlpha2();
                glm::vec3 d;
                float len;
                // Integer sums are exact, so that only the codes are rounded.
                glm::vec3 exact;
                for (int c = 0; c < 3; ++c)
                    exact[c] = math_f::agaa_signedMeanOfSum(n * math_f::agaa_signedCode(normal[c], bits), n, bits);
                math_f::agaa_meanDirection(exact, normal, d, len);
                const float ownFloor = math_f::agaa_varianceFloor(len, math_f::agaa_storedLengthBound(1, bits));
                figures.ours(std::sqrt(double(math_f::agaa_toksvigAlpha2(a, ownFloor))) - mirror);
                // A blender rounds after every addition, up or down by up to a whole code: twice the bound of
                // rounding to nearest.
                math_f::agaa_meanDirection(blendedMean(random, normal, n, bits), normal, d, len);
                untreated = std::max(untreated, std::sqrt(double(math_f::agaa_toksvigAlpha2(a, len))) - mirror);
                const float blenderFloor = math_f::agaa_varianceFloor(len, math_f::agaa_storedLengthBound(2 * n, bits));
                figures.ours(std::sqrt(double(math_f::agaa_toksvigAlpha2(a, blenderFloor))) - mirror, 0);
            }
            std::printf("[ measured ] mirror, RGB%u, n=%u: alpha above its own without the floor %.4f\n", bits, n,
                        untreated);
            EXPECT_GT(untreated, bits == 16 ? 0.01 : 0.1);
            figures.naive(untreated);
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

TEST(HardCase09_RoughnessConventions, WideningAlphaInPlaceOfItsSquare) {
    Random random(109);
    HardCaseFigures figures(9, "relative error of the widened alpha²", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        const float alpha = float(random.decades(0.002025, 1)), len = random.rangeF(0, 1);
        const float mistaken = math_f::agaa_toksvigAlpha2(alpha, len);
        figures.relative(double(mistaken * mistaken), double(math_f::agaa_toksvigAlpha2(alpha * alpha, len)),
                         printedToksvig(double(alpha), double(len)));
    }
    // It filters too little: alpha .05 at the length .9 becomes .23, not .41.
    EXPECT_LT(math_f::agaa_toksvigAlpha2(0.05f, 0.9f), 0.6f * std::sqrt(math_f::agaa_toksvigAlpha2(0.0025f, 0.9f)));
}

TEST(HardCase09_RoughnessConventions, RoundTripIsTheIdentity) {
    Worst ulps("alpha2 -> exponent -> alpha2 at length 1: units in the last place", 2.0);
    Random random(109);
    for (int i = 0; i < 100000; ++i) {
        const float a = static_cast<float>(i % 2 ? random.decades(4.2e-6, 1) : random.range(1e-5, 1));
        const float s = math_f::agaa_exponentFromAlpha2(a);
        const float back = math_f::agaa_toksvigAlpha2(2.0f / (s + 2.0f), 1.0f);
        ulps.add(std::abs(double(back) - double(a)) / double(std::nextafter(a, 2.0f) - a));
    }
    // s = 2/alpha2 - 2.
    EXPECT_NEAR(math_f::agaa_exponentFromAlpha2(0.0625f), 30.0f, 1e-5f);
}
