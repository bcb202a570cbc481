// Coverage masks of triangles without an area, behind the eye and with extreme coordinates
// (src/shaders/math/triangle_coverage.glsl).
#include "coverage_oracle.h"

using namespace test_math;

namespace {

// Hard case 48.
TEST(TriangleCoverageLimits, TrianglesWithoutAreaCoverNothing) {
    Random random(48);
    const glm::vec2 centre(200.5f, 100.5f);
    std::size_t bits = 0;
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = 32u << random.below(3);
        // Multiples of 1/512: differences and products of these are exact.
        const auto dyadic = [&] { return double(int(random.below(2048)) - 1024) / 512; };
        const glm::dvec2 p(200.5 + dyadic(), 100.5 + dyadic()), d(dyadic() / 4, dyadic() / 4);
        const glm::vec3 a = vertex(p.x, p.y), b = vertex(p.x + d.x, p.y + d.y);
        const glm::vec3 c = vertex(p.x + 4 * d.x, p.y + 4 * d.y);
        for (const Vertices& t : {Vertices{a, b, c}, {b, a, c}, {c, b, a}, {a, a, b}, {a, b, a}, {b, a, a}, {a, a, a}})
            bits += math_f::agaa_coverageCount(mask(t, centre, n));
    }
    EXPECT_EQ(bits, 0u);
    for (const float bad : {infinityF(), -infinityF(), nanF()})
        for (int k = 0; k < 9; ++k) {
            Vertices t = {vertex(190, 90), vertex(220, 90), vertex(200, 120)};
            t[static_cast<std::size_t>(k / 3)][k % 3] = bad;
            EXPECT_EQ(mask(t, centre, 64), glm::uvec4(0)) << k;
        }
}

// Hard case 50.
TEST(TriangleCoverageLimits, TrianglesThroughTheEyePlane) {
    Random random(50);
    std::size_t covered = 0, behind = 0;
    unsigned worst = 0;
    for (int i = 0; i < 200000; ++i) {
        const glm::vec2 centre(float(random.below(1920)) + 0.5f, float(random.below(1080)) + 0.5f);
        Vertices t;
        for (glm::vec3& v : t) {
            const double w = random.range(-1, 1), size = random.decades(1, 1000);
            v = glm::vec3(glm::dvec3(double(centre.x) * w + random.range(-1, 1) * size,
                                     double(centre.y) * w + random.range(-1, 1) * size, w));
        }
        // Clipped to w > 0, as polygon in the plane of the image, tested by sides.
        Polygon polygon;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a(t[k]), b(t[(k + 1) % 3]);
            const double lowest = 1e-7;
            if (a.z >= lowest)
                polygon.push_back({a.x / a.z - double(centre.x), a.y / a.z - double(centre.y)});
            if ((a.z >= lowest) != (b.z >= lowest)) {
                const glm::dvec3 p = glm::mix(a, b, (lowest - a.z) / (b.z - a.z));
                polygon.push_back({p.x / p.z - double(centre.x), p.y / p.z - double(centre.y)});
            }
        }
        if (areaOf(polygon) < 0)
            std::reverse(polygon.begin(), polygon.end());
        glm::uvec4 expected(0);
        for (unsigned s = 0; s < 64 && polygon.size() > 2; ++s) {
            bool inside = true;
            const glm::dvec2 p = math_d::agaa_coveragePosition(s, 64);
            for (std::size_t k = 0; k < polygon.size(); ++k) {
                const glm::dvec2 d = polygon[(k + 1) % polygon.size()] - polygon[k], e = p - polygon[k];
                inside = inside && d.x * e.y - d.y * e.x > 0;
            }
            if (inside)
                expected[static_cast<int>(s >> 5)] |= 1u << (s & 31);
        }
        const glm::uvec4 found = mask(t, centre, 64);
        worst = std::max(worst, differingBits(expected, found));
        const unsigned count = math_f::agaa_coverageCount(expected);
        covered += count != 0 && count != 64;
        behind += polygon.empty();
        if (polygon.empty()) {
            EXPECT_EQ(found, glm::uvec4(0));
        }
    }
    EXPECT_GT(covered, 3000u);
    EXPECT_GT(behind, 10000u);
    std::printf("[ measured ] partly covered pixels %zu, wrong bits at most %u of 64\n", covered, worst);
    EXPECT_LE(worst, 2u);
}

// Homogeneous vertices times a number are the same vertices.
TEST(TriangleCoverageLimits, LargeAndSmallCoordinatesCoverTheSame) {
    Random random(52);
    const glm::vec2 centre(77.5f, 33.5f);
    for (int i = 0; i < 10000; ++i) {
        Vertices t;
        for (glm::vec3& v : t)
            v = vertex(77 + random.range(-3, 4), 33 + random.range(-3, 4), random.decades(0.1, 10));
        const glm::uvec4 expected = mask(t, centre, 64);
        for (const float factor : {0x1p-80f, 0x1p-30f, 0x1p30f, 0x1p80f})
            ASSERT_EQ(mask({t[0] * factor, t[1], t[2] * factor}, centre, 64), expected) << factor;
    }
}

TEST(TriangleCoverageLimits, ExtremeInputIsDecided) {
    const std::vector<float> values = {0.0f, 1e-40f, -1e-20f, 1.0f, -3.0f, 1e12f, -1e20f, 3e38f};
    Random random(51);
    const auto pick = [&] { return values[random.below(unsigned(values.size()))]; };
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 a(pick(), pick(), pick()), b(pick(), pick(), pick()), c(pick(), pick(), pick());
        const glm::vec2 centre(0.5f, 16383.5f);
        EXPECT_EQ(mask({a, b, c}, centre, 64) & ~math_f::agaa_allCoverage(64), glm::uvec4(0));
        if (a.z <= 0 && b.z <= 0 && c.z <= 0) {
            EXPECT_EQ(mask({a, b, c}, centre, 64), glm::uvec4(0));
        }
    }
}

} // namespace
