// Coverage masks of triangles (src/shaders/math/triangle_coverage.glsl).
#include "coverage_oracle.h"

using namespace test_math;

namespace {

constexpr std::array<unsigned, 3> sampleCounts = {32, 64, 128};

glm::uvec4 edgeMask(const glm::vec3& a, const glm::vec3& b, const glm::vec2& centre, unsigned samples) {
    return math_f::agaa_edgeCoverage(
        math_f::agaa_edgeFromCentre(math_f::agaa_vertexFromCentre(a, centre), math_f::agaa_vertexFromCentre(b, centre)),
        samples);
}

TEST(CoveragePattern, SamplesAreDistinctInsideAndExactInFloat) {
    for (const unsigned n : sampleCounts) {
        EXPECT_EQ(math_f::agaa_coverageCount(math_f::agaa_allCoverage(n)), n);
        std::vector<std::pair<double, double>> seen;
        glm::dvec2 mean(0);
        for (unsigned i = 0; i < n; ++i) {
            const glm::dvec2 p = math_d::agaa_coveragePosition(i, n);
            EXPECT_EQ(glm::dvec2(math_f::agaa_coveragePosition(i, n)), p);
            EXPECT_LT(std::max(std::abs(p.x), std::abs(p.y)), 0.5);
            seen.emplace_back(p.x, p.y);
            mean += p / double(n);
        }
        std::sort(seen.begin(), seen.end());
        EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
        EXPECT_LT(glm::length(mean), 0.002);
    }
}

struct Errors {
    std::size_t bits = 0, samples = 0, pixels = 0, fragments = 0;
    unsigned worst = 0;
    void add(unsigned wrong, unsigned covered) {
        bits += wrong;
        samples += covered;
        pixels += wrong != 0;
        ++fragments;
        worst = std::max(worst, wrong);
    }
    double report(const char* what) const {
        const double share = double(bits) / double(std::max<std::size_t>(samples, 1));
        std::printf("[ measured ] %s: %.5f %% of %zu covered samples wrong, %.4f %% of fragments, at most %u\n", what,
                    100 * share, samples, 100 * double(pixels) / double(std::max<std::size_t>(fragments, 1)), worst);
        return share;
    }
};

// A pixel near the triangle's middle, so that edges pass through pixels.
glm::vec2 pixelNear(Random& random, const glm::dvec2& at) {
    return glm::vec2(std::floor(at.x) + 0.5, std::floor(at.y + random.range(-0.5, 0.5)) + 0.5);
}

TEST(TriangleCoverage, FloatAgreesWithTheOracle) {
    Errors small, large, spread, far;
    for (const unsigned n : sampleCounts) {
        Random random(n);
        for (int i = 0; i < 60000; ++i) {
            const bool big = i % 2 == 1, extreme = i % 8 == 7;
            const double size = extreme ? random.decades(1e4, 1e6)
                                : big   ? random.decades(3, 4000)
                                        : random.decades(0.02, 3);
            const glm::dvec2 at(random.range(0, 16384), random.range(0, 16384));
            Vertices t;
            for (glm::vec3& v : t)
                v = vertex(at.x + size * random.range(-1, 1), at.y + size * random.range(-1, 1),
                           i % 4 < 2 ? 1
                           : extreme ? random.decades(1e-6, 1e6)
                                     : random.decades(0.01, 1000));
            // A point of an edge or of the inside.
            const double u = random.unit();
            const glm::dvec2 p(t[0].x / t[0].z, t[0].y / t[0].z), q(t[1].x / t[1].z, t[1].y / t[1].z);
            const glm::vec2 centre = pixelNear(random, glm::mix(p, q, u));
            const glm::uvec4 expected = oracleMask(t, centre, n), found = mask(t, centre, n);
            EXPECT_EQ(found, mask({t[2], t[1], t[0]}, centre, n));
            (extreme      ? far
             : i % 4 >= 2 ? spread
             : big        ? large
                          : small)
                .add(differingBits(expected, found), math_f::agaa_coverageCount(expected));
        }
    }
    EXPECT_LT(small.report("small triangles, w = 1"), 2e-5);
    EXPECT_LT(large.report("large triangles, w = 1"), 2e-5);
    EXPECT_LT(spread.report("any size, w from 0.01 to 1000"), 2e-5);
    EXPECT_LT(far.report("10^4 to 10^6 pixels, w from 10^-6 to 10^6"), 1e-2);
    EXPECT_LE(std::max({small.worst, large.worst, spread.worst}), 2u);
}

TEST(TriangleCoverage, DoubleIsExact) {
    Random random(5);
    for (int i = 0; i < 30000; ++i) {
        const double size = random.decades(0.02, 3000);
        Vertices t;
        for (glm::vec3& v : t)
            v = vertex(100 + size * random.range(-1, 1), 50 + size * random.range(-1, 1), random.decades(0.01, 100));
        const glm::dvec2 centre(100.5, 50.5);
        EXPECT_EQ(differingBits(math_d::agaa_triangleCoverage(t[0], t[1], t[2], centre, 64), oracleMask(t, centre, 64)),
                  0u);
    }
}

// Hard case 47: the two sides of an edge are complements, also where samples are on the edge.
TEST(TriangleCoverage, SharedEdgesSplitTheSamples) {
    Random random(47);
    std::size_t split = 0;
    for (int i = 0; i < 1000000; ++i) {
        const unsigned n = sampleCounts[random.below(3)];
        const glm::vec2 centre(float(random.below(16384)) + 0.5f, float(random.below(16384)) + 0.5f);
        glm::vec3 a, b;
        for (glm::vec3* v : {&a, &b}) {
            const double reach = i % 3 == 0 ? 1 : random.decades(0.1, 1e4);
            const double x = random.range(-reach, reach), y = random.range(-reach, reach);
            // Every other edge ends on sample positions, or passes through them level or upright.
            const glm::vec2 hit = math_f::agaa_coveragePosition(random.below(n), n);
            *v = i % 2 ? vertex(double(centre.x + hit.x), double(centre.y + hit.y), i % 4 == 1 ? 1 : 0.25)
                       : vertex(double(centre.x) + x, double(centre.y) + y, random.range(-1, 4));
            if (i % 8 == 1)
                v->x += float(random.below(5)) - 2.0f;
        }
        if (i % 16 == 3)
            b.x = a.x / a.z * b.z;
        const glm::uvec4 left = edgeMask(a, b, centre, n), right = edgeMask(b, a, centre, n);
        const bool equal = a == b;
        if (!equal) {
            ASSERT_EQ(left & right, glm::uvec4(0)) << i;
            ASSERT_EQ(left | right, math_f::agaa_allCoverage(n)) << i;
        }
        split += left != glm::uvec4(0) && right != glm::uvec4(0);
    }
    EXPECT_GT(split, 400000u);
}

// A sample anywhere in the pixel is covered by the rules of rows, and belongs to one side of an edge.
TEST(TriangleCoverage, EdgesCoverSamplesOfTargetsAsRows) {
    Random random(51);
    size_t split = 0, onLine = 0;
    for (int i = 0; i < 100000; ++i) {
        const unsigned n = sampleCounts[random.below(3)];
        const glm::vec2 centre(float(random.below(4096)) + 0.5f, float(random.below(4096)) + 0.5f);
        const auto end = [&] {
            const double reach = i % 3 == 0 ? 1 : random.decades(0.1, 1e4);
            return vertex(double(centre.x) + random.range(-reach, reach),
                          double(centre.y) + random.range(-reach, reach), random.range(0.1, 4));
        };
        const glm::vec3 a = math_f::agaa_vertexFromCentre(end(), centre);
        const glm::vec3 b =
            i % 5 == 0 ? a * glm::vec3(-2, 1, 1) : math_f::agaa_vertexFromCentre(end(), centre); // level
        const math_f::agaa_Edge edge = math_f::agaa_edgeFromCentre(a, b), back = math_f::agaa_edgeFromCentre(b, a);
        const glm::uvec4 row = math_f::agaa_edgeCoverage(edge, n);
        for (unsigned s = 0; s < n; ++s) {
            const glm::vec2 at = math_f::agaa_coveragePosition(s, n);
            const bool covers = math_f::agaa_edgeCovers(edge, at);
            split += covers;
            ASSERT_NE(covers, math_f::agaa_edgeCovers(back, at)) << i << ", sample " << s;
            onLine += covers != math_f::agaa_isCovered(row, s);
        }
    }
    EXPECT_GT(split, 100000u);
    EXPECT_LT(onLine, split / 100000) << "rounding decides for samples on the line";
}

TEST(TriangleCoverage, SliversAreExact) {
    Random random(49);
    Errors errors;
    for (int i = 0; i < 100000; ++i) {
        const double length = random.decades(1, 3000), width = random.decades(1e-3, 0.1), turn = random.range(0, 6.3);
        const glm::dvec2 at(500 + random.range(-1, 1), 700 + random.range(-1, 1)), d(std::cos(turn), std::sin(turn));
        const glm::dvec2 p = at - d * length * random.unit(), q = p + d * length;
        const Vertices t = {vertex(p.x, p.y), vertex(q.x, q.y), vertex(q.x - d.y * width, q.y + d.x * width)};
        const glm::dvec2 centre(500.5, 700.5);
        const glm::uvec4 expected = oracleMask(t, centre, 64);
        errors.add(differingBits(expected, mask(t, centre, 64)), math_f::agaa_coverageCount(expected));
    }
    EXPECT_GT(errors.samples, 10000u);
    EXPECT_LT(errors.report("slivers"), 2e-3);
    EXPECT_LE(errors.worst, 2u);
}

} // namespace
