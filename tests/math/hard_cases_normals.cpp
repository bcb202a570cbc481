// Hard cases 10 to 13 of docs/numerics.md: codes of normals, and differences between them.
#include <cfloat>

#include "hard_case_figures.h"
#include "test_support.h"

using namespace test_math;

namespace {

constexpr double pi = 3.14159265358979323846;

// The paper's code: two angles of 8 bits each.
glm::ivec2 anglesOf(const glm::dvec3& n) {
    double phi = std::atan2(n.y, n.x) / (2 * pi);
    phi = phi < 0 ? phi + 1 : phi;
    return {int(std::acos(std::clamp(n.z, -1.0, 1.0)) / (pi / 2) * 255 + 0.5), int(phi * 255 + 0.5)};
}

glm::dvec3 fromAngles(const glm::dvec2& code) {
    const double theta = code.x / 255 * (pi / 2), phi = code.y / 255 * 2 * pi;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// Crytek's sphere map of a normal.
glm::vec2 sphereMap(const glm::vec3& n) {
    const glm::vec2 p(n.x, n.y);
    return p / glm::length(p) * std::sqrt(n.z * -0.5f + 0.5f) * 0.5f + 0.5f;
}

glm::vec3 fromSphereMap(const glm::vec2& code) {
    const glm::vec2 e = code * 2.0f - 1.0f;
    const float z = 1.0f - 2.0f * glm::dot(e, e);
    const glm::vec2 p = e / glm::length(e) * std::sqrt(1.0f - z * z);
    return {p.x, p.y, z};
}

glm::dvec3 throughHemiOct(const glm::dvec3& n) {
    return glm::dvec3(math_f::agaa_decodeHemiOct8(math_f::agaa_encodeHemiOct8(glm::vec3(n))));
}

} // namespace

TEST(HardCase10_NormalCodes, MeansOfCodesOfAngles) {
    Random random(210);
    HardCaseFigures figures(10, "degrees between the mean of two normals and its code", 0.7);
    Worst angles("code of angles of one normal: degrees", 0.73), octahedral("hemi-octahedral code: degrees", 0.55);
    Worst floor("Equation 1 between a normal and its decoded code", 9e-5);
    for (int i = 0; i < 200000; ++i) {
        glm::dvec3 a = random.hemisphere(0.01);
        if (i % 2)
            a = glm::normalize(glm::dvec3(std::abs(a.x), a.y * 1e-3, a.z)); // near the seam
        const glm::dvec3 apart = random.direction() * 0.01;
        const glm::dvec3 b = glm::normalize(glm::dvec3(a.x + apart.x, a.y + apart.y, a.z));
        angles.add(degreesBetween(a, fromAngles(anglesOf(a))));
        octahedral.add(degreesBetween(a, throughHemiOct(a)));
        const glm::dvec3 d = throughHemiOct(a) - a;
        floor.add(glm::dot(d, d) / 4.0);
        // The SDK averages decoded normals, never codes.
        figures.add(degreesBetween(a + b, fromAngles(glm::dvec2(anglesOf(a) + anglesOf(b)) * 0.5)),
                    degreesBetween(a + b, throughHemiOct(a) + throughHemiOct(b)));
    }
}

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
        seam.add(degreesBetween(throughHemiOct({r, r * 5e-7, z}), throughHemiOct({r, -r * 5e-7, z})));
    }
}

TEST(HardCase11_SphereMapPoles, SphereMapsAreNotFinite) {
    Random random(211);
    HardCaseFigures figures(11, "degrees between a normal and its 16-bit code", 0.005);
    const glm::vec3 poles[] = {{0, 0, 1}, {0, 0, -1}, {0, -0.0f, 1}, {-0.0f, 0, -1}};
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 n = i < 4 ? poles[i] : glm::vec3(random.direction());
        figures.add(
            degreesBetween(glm::dvec3(n), glm::dvec3(fromSphereMap(sphereMap(n)))),
            degreesBetween(glm::dvec3(n), glm::dvec3(math_f::agaa_decodeOct(math_f::agaa_encodeOct(n, 16), 16))));
    }
    // Codes outside the disc, which filtering makes.
    EXPECT_TRUE(std::isnan(fromSphereMap({0.999f, 0.999f}).x));
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

TEST(HardCase12_FlippedNormals, SignedProductCounts) {
    Random random(112);
    HardCaseFigures figures(12, "error of sqrt(1 - n.n)", 6e-4);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 a(random.direction());
        const glm::vec3 near(glm::normalize(glm::dvec3(a) + random.decades(1e-3, 1) * random.direction()));
        const glm::vec3 b = i % 2 ? -near : near;
        const double reference = std::sqrt(std::max(1.0 - glm::dot(glm::dvec3(a), glm::dvec3(b)), 0.0));
        figures.add(std::abs(std::sqrt(std::max(1.0 - double(std::abs(glm::dot(a, b))), 0.0)) - reference),
                    std::abs(double(math_f::agaa_normalMetric(glm::dot(a, b))) - reference));
        // The metric that chooses samples is exact: it squares the difference.
        ASSERT_NEAR(double(math_f::agaa_normalStep(a, b, 0.5f)),
                    math_d::agaa_normalStep(glm::dvec3(a), glm::dvec3(b), 0.5), 1e-6);
    }
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
    HardCaseFigures figures(13, "sqrt(1 - n.n) of equal normals", 5e-4);
    Share above;
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 n(random.direction());
        const float d = glm::dot(n, n);
        above.add(d > 1.0f);
        figures.add(double(std::sqrt(1.0f - d)), double(math_f::agaa_normalMetric(d)));
        ASSERT_EQ(math_f::agaa_normalStep(n, n, 0.9f), 0.0f);
    }
    std::printf("[ measured ] n.n above 1 for %.1f %% of rounded unit vectors\n", 100.0 * above.value());
    EXPECT_GT(above.value(), 0.01);
}
