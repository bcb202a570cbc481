// Hard cases 6 to 8 and 58 of docs/numerics.md: elliptic lobes from moments of normals, and narrow lobes.
#include <cfloat>

#include <glm/gtc/packing.hpp>

#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

namespace {

// Lower eigenvalue of a symmetric matrix of two rows.
template <class T> T leastEigenvalue(T xx, T yy, T xy) {
    const T skew = T(0.5) * (xx - yy);
    return T(0.5) * (xx + yy) - std::sqrt(skew * skew + xy * xy);
}

struct Widths {
    double along = 0, across = 0;
};

// The widened lobe of these normals.
Widths widthsOf(const std::vector<glm::vec3>& normals, float alpha2, unsigned sggx) {
    math_f::agaa_SecondMoments m{glm::vec3(0), glm::vec3(0)};
    glm::vec3 sum(0), mean, axis;
    float len, along, across;
    for (const glm::vec3& n : normals) {
        math_f::agaa_addSecondMoments(m, 1.0f / float(normals.size()), n);
        sum += n / float(normals.size());
    }
    math_f::agaa_meanDirection(sum, normals[0], mean, len);
    math_f::agaa_spreadAlpha2(m, mean, len, alpha2, sggx, 0.0f, axis, along, across);
    return {double(along), double(across)};
}

// alpha2 across the lobe in double, from the eigenvalues of the matrices of the papers: (1 - a) S + a I for SGGX, and
// a + 2 C for LEAN mapping, of which C has the second moments of normals over those along the mean. Scattered normals
// make the lobe wider, as agaa_spreadAlpha2() says.
double exactAcross(const std::vector<glm::vec3>& normals, double alpha2, bool isSggx) {
    glm::dvec3 sum(0), t, b;
    for (const glm::vec3& n : normals)
        sum += glm::dvec3(n) / double(normals.size());
    const double length = std::min(glm::length(sum), 1.0);
    const glm::dvec3 mean = glm::normalize(sum);
    math_d::agaa_viewBasis(mean, t, b);
    double xx = 0, yy = 0, xy = 0, zz = 0;
    for (const glm::vec3& normal : normals) {
        const glm::dvec3 n(normal);
        const double x = glm::dot(n, t), y = glm::dot(n, b), z = glm::dot(n, mean),
                     share = 1.0 / double(normals.size());
        xx += share * x * x;
        yy += share * y * y;
        xy += share * x * y;
        zz += share * z * z;
    }
    const double least = std::max(leastEigenvalue(xx, yy, xy), 0.0);
    const double across = std::min(1.0, isSggx ? (alpha2 + (1 - alpha2) * least) / (alpha2 + (1 - alpha2) * zz)
                                               : alpha2 + 2 * least / std::max(zz, 1e-3));
    const double facing = std::min(4 * length * length, 1.0);
    return std::max(across + (1 - facing) * (1 - across), alpha2);
}

// Normals around a direction, some of them all equal, as a layout of `bits` stores them.
std::vector<glm::vec3> storedNormals(Random& random, const glm::dvec3& middle, double radius, unsigned bits) {
    std::vector<glm::vec3> normals(1u << random.below(4));
    for (glm::vec3& n : normals) {
        n = glm::vec3(glm::normalize(middle + radius * random.direction()));
        n = math_f::agaa_decodeOct(math_f::agaa_encodeOct(n, bits), bits);
    }
    return normals;
}

} // namespace

TEST(HardCase06_SggxRankOne, ProjectedAreasHaveAFloor) {
    Random random(106);
    HardCaseFigures figures(6, "relative error of 1 / alpha across the lobe", 0.03);
    const unsigned bits[] = {8, 11, 16};
    for (int i = 0; i < 100000; ++i) {
        const double radius = i % 4 ? random.decades(1e-4, 1) : 0.0;
        const std::vector<glm::vec3> normals = storedNormals(random, random.direction(), radius, bits[i % 3]);
        const float a2 = i % 8 ? float(random.decades(4.2e-6, 1)) : math_f::agaa_minAlpha2();
        const Widths is = widthsOf(normals, a2, 1);
        ASSERT_GE(is.across, double(a2));
        ASSERT_GE(is.along, is.across);
        ASSERT_LE(is.along, 1.0);
        // The matrix of the paper has no term of the roughness, so that its inverse is infinite for one normal.
        math_f::agaa_SecondMoments m{glm::vec3(0), glm::vec3(0)};
        for (const glm::vec3& n : normals)
            math_f::agaa_addSecondMoments(m, 1.0f / float(normals.size()), n);
        glm::vec3 t, b;
        math_f::agaa_viewBasis(normals[0], t, b);
        const float area = math_f::agaa_momentAlong(m, normals[0], normals[0]);
        const float least = leastEigenvalue(math_f::agaa_momentAlong(m, t, t), math_f::agaa_momentAlong(m, b, b),
                                            math_f::agaa_momentAlong(m, t, b));
        figures.relative(double(std::sqrt(area / least)), 1 / std::sqrt(is.across),
                         1 / std::sqrt(exactAcross(normals, double(a2), true)));
    }
}

// Correlations stay in [-1, 1], whatever the codes are.
TEST(HardCase06_SggxRankOne, MomentsOfStoredNormalsAreAMatrixOfSquares) {
    Random random(1106);
    Worst negative("moments of stored normals: square of the mixed one above the product of the others", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        math_f::agaa_SecondMoments m{glm::vec3(0), glm::vec3(0)};
        const auto normals = storedNormals(random, random.direction(), random.decades(1e-4, 1), 8);
        for (const glm::vec3& n : normals)
            math_f::agaa_addSecondMoments(m, 1.0f / float(normals.size()), n);
        for (int k = 0; k < 3; ++k)
            negative.add(std::max(0.0, double(m.mixed[k]) * double(m.mixed[k]) -
                                           double(m.squares[(k + 1) % 3]) * double(m.squares[(k + 2) % 3])));
    }
}

TEST(HardCase07_NegativeLeanCovariance, SecondMomentsOfUnitNormals) {
    Random random(107);
    HardCaseFigures figures(7, "relative error of alpha across the lobe", 0.05);
    Share negative;
    for (int i = 0; i < 100000; ++i) {
        const double radius = i % 4 ? random.decades(1e-4, 1) : 0.0;
        const std::vector<glm::vec3> normals = storedNormals(random, random.hemisphere(i % 8 ? 0.1 : 1e-3), radius, 11);
        const float a2 = i % 5 ? float(random.decades(4.2e-6, 1)) : math_f::agaa_minAlpha2();
        // LEAN mapping as printed: means of slopes and of their products, in half floats.
        glm::vec2 slope(0), squares(0);
        float product = 0;
        for (const glm::vec3& n : normals) {
            const glm::vec2 b = glm::vec2(n.x, n.y) / n.z;
            const float share = 1.0f / float(normals.size());
            slope += share * b;
            squares += share * b * b;
            product += share * b.x * b.y;
        }
        const float sx = asHalf(slope.x), sy = asHalf(slope.y);
        const float least =
            leastEigenvalue(asHalf(squares.x) - sx * sx, asHalf(squares.y) - sy * sy, asHalf(product) - sx * sy);
        negative.add(!(least >= 0.0f));
        const Widths is = widthsOf(normals, a2, 0);
        ASSERT_GE(is.across, double(a2));
        ASSERT_GE(is.along, is.across);
        ASSERT_LE(is.along, 1.0);
        figures.relative(double(std::sqrt(a2 + 2.0f * least)), std::sqrt(is.across),
                         std::sqrt(exactAcross(normals, double(a2), false)));
    }
    std::printf("[ measured ] covariances of slopes in half floats that are negative or not finite: %.1f %%\n",
                100 * negative.value());
    EXPECT_GT(negative.value(), 0.1);
}

TEST(HardCase08_GgxTinyAlpha, CrossFormAgainstDouble) {
    Random random(108);
    HardCaseFigures figures(8, "relative error of GGX", 1.5e-4);
    for (int i = 0; i < 200000; ++i) {
        const double alpha = random.decades(0.002025, 1.0);
        const float a2 = std::max(float(alpha * alpha), math_f::agaa_minAlpha2());
        const glm::dvec3 nd = random.direction();
        const glm::vec3 n(nd);
        const glm::vec3 h(glm::normalize(nd + alpha * random.range(0.1, 3) * random.direction()));
        const glm::vec3 c = glm::cross(n, h);
        const glm::dvec3 cd = glm::cross(glm::dvec3(n), glm::dvec3(h));
        const double reference = math_d::agaa_ggxD(a2, glm::dot(glm::dvec3(n), glm::dvec3(h)), glm::dot(cd, cd));
        const float noH = glm::dot(n, h);
        const float plain = a2 / (math_f::agaa_pi() * math_f::agaa_sq(noH * noH * (a2 - 1.0f) + 1.0f));
        figures.relative(double(plain), double(math_f::agaa_ggxD(a2, noH, glm::dot(c, c))), reference);
    }
    // Below the floor the textbook form is infinite, at 0 not a number.
    const auto textbook = [](float a2) { return a2 / (math_f::agaa_pi() * math_f::agaa_sq((a2 - 1.0f) + 1.0f)); };
    EXPECT_TRUE(std::isnan(textbook(0.0f)));
    EXPECT_TRUE(std::isinf(textbook(1e-12f)));
    for (float a : {0.0f, -1.0f, FLT_TRUE_MIN, 1e-12f}) {
        const float d = math_f::agaa_ggxD(a, 1.0f, 0.0f);
        EXPECT_NEAR(d, 1.0f / (3.14159265f * 4.100625e-6f), 1.0f) << a;
    }
    // The floor is the one whose peak half floats hold with a margin: 77,600 overflows, a share of light does not.
    EXPECT_LT(math_f::agaa_ggxD(0.0f, 1.0f, 0.0f), 78000.0f);
}

TEST(HardCase58_BlinnPhongHighExponents, AgainstDouble) {
    Random random(158);
    HardCaseFigures figures(58, "relative error of Blinn-Phong", 1e-5);
    Worst near("Blinn-Phong, s 1..1e6, h within 1e-4 of n: relative", 2e-6);
    for (int i = 0; i < 200000; ++i) {
        const float s = static_cast<float>(random.decades(1, 1e6));
        const double angle =
            i % 2 ? random.decades(1e-8, 1e-4) : std::min(1.5, random.range(0, 4) / std::sqrt(double(s)));
        const float sin2 = static_cast<float>(std::sin(angle) * std::sin(angle));
        const float cosine = static_cast<float>(std::cos(angle));
        // The reference uses the cosine that belongs to the given sine.
        const double logCosine = sin2 < 0.5f ? 0.5 * std::log1p(-double(sin2)) : std::log(double(cosine));
        const double reference = (double(s) + 2.0) / 6.283185307179586 * std::exp(double(s) * logCosine);
        const double is = double(math_f::agaa_blinnPhong(s, sin2, cosine));
        figures.relative((double(s) + 2.0) / 6.283185307179586 * double(std::pow(cosine, s)), is, reference);
        if (i % 2)
            near.relative(is, reference);
    }
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
