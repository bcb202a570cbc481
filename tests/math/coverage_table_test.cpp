// Coverage by a table of half-planes (src/shaders/math/coverage_table.glsl).
#include "coverage_oracle.h"

using namespace test_math;

namespace {

using Table = std::vector<glm::uvec4>;

// positions: from the pixel's centre, any pattern of up to 128 samples.
Table fill(unsigned size, const std::vector<glm::vec2>& positions) {
    Table table(size * size + 1, glm::uvec4(0));
    for (unsigned entry = 0; entry < size * size; ++entry)
        for (unsigned i = 0; i < positions.size(); ++i)
            if (math_f::agaa_isInTableEntry(entry, size, positions[i]))
                table[entry][static_cast<int>(i >> 5)] |= 1u << (i & 31);
    return table;
}

std::vector<glm::vec2> pattern(unsigned samples) {
    std::vector<glm::vec2> positions;
    for (unsigned i = 0; i < samples; ++i)
        positions.push_back(math_f::agaa_coveragePosition(i, samples));
    return positions;
}

glm::uvec4 edgeMask(const Table& table, unsigned size, const glm::vec3& a, const glm::vec3& b, unsigned samples) {
    const math_f::agaa_CoverageLookup found = math_f::agaa_findCoverage(a, b, size);
    return math_f::agaa_foundCoverage(found, table.at(found.entry), samples);
}

glm::uvec4 mask(const Table& table, unsigned size, const Vertices& t, const glm::vec2& centre, unsigned samples) {
    const glm::vec3 a = math_f::agaa_vertexFromCentre(t[0], centre), b = math_f::agaa_vertexFromCentre(t[1], centre),
                    c = math_f::agaa_vertexFromCentre(t[2], centre);
    return math_f::agaa_joinEdges(a, b, c, edgeMask(table, size, b, c, samples), edgeMask(table, size, c, a, samples),
                                  edgeMask(table, size, a, b, samples), samples);
}

// Hard case 47.
TEST(CoverageTable, SharedEdgesSplitTheSamples) {
    for (const unsigned n : {32u, 64u, 128u}) {
        const Table table = fill(64, pattern(n));
        Random random(n);
        for (int i = 0; i < 300000; ++i) {
            const double reach = random.decades(0.1, 1e4);
            glm::vec3 a(random.range(-reach, reach), random.range(-reach, reach), random.range(-1, 4));
            glm::vec3 b(random.range(-reach, reach), random.range(-reach, reach), random.range(-1, 4));
            if (i % 4 == 0) { // level, upright or through samples
                a = glm::vec3(math_f::agaa_coveragePosition(random.below(n), n), 1);
                b = glm::vec3(math_f::agaa_coveragePosition(random.below(n), n), 1);
            }
            if (i % 16 == 3)
                b.x = a.x / a.z * b.z;
            const glm::uvec4 left = edgeMask(table, 64, a, b, n), right = edgeMask(table, 64, b, a, n);
            if (a != b) {
                ASSERT_EQ(left & right, glm::uvec4(0)) << i;
                ASSERT_EQ(left | right, math_f::agaa_allCoverage(n)) << i;
            }
        }
    }
}

// Twice the size halves the error. Thin triangles of a few pixels, as in grass, have much edge for their area.
TEST(CoverageTable, ErrorFallsWithTheSize) {
    constexpr std::array<double, 6> bounds = {0.14, 0.07, 0.035, 0.018, 0.009, 0.005};
    for (std::size_t k = 0; k < bounds.size(); ++k) {
        const unsigned size = 16u << k;
        const Table table = fill(size, pattern(64));
        Random random(7);
        std::size_t wrong = 0, covered = 0, fragments = 0, wrongFragments = 0;
        for (int i = 0; i < 20000; ++i) {
            const double length = random.decades(1, 30), width = random.decades(0.2, 5), turn = random.range(0, 6.3);
            const glm::dvec2 d(std::cos(turn), std::sin(turn)), p(100 + random.unit(), 200 + random.unit());
            const Vertices t = {vertex(p.x, p.y), vertex(p.x + length * d.x, p.y + length * d.y),
                                vertex(p.x - width * d.y, p.y + width * d.x)};
            const glm::dvec2 at = glm::floor(p + d * length * random.unit()) + 0.5;
            const glm::uvec4 expected = oracleMask(t, at, 64), found = mask(table, size, t, at, 64);
            wrong += differingBits(expected, found);
            covered += math_f::agaa_coverageCount(expected);
            fragments += expected != glm::uvec4(0);
            wrongFragments += expected != found;
        }
        const double share = double(wrong) / double(covered);
        std::printf("[ measured ] table of %3u x %3u: %.2f %% of covered samples wrong, %.1f %% of fragments\n", size,
                    size, 100 * share, 100 * double(wrongFragments) / double(fragments));
        EXPECT_LT(share, bounds[k]);
    }
}

// The table serves patterns without rows.
TEST(CoverageTable, AnyPattern) {
    Random random(8);
    std::vector<glm::vec2> positions;
    for (unsigned i = 0; i < 64; ++i)
        positions.push_back({random.rangeF(-0.5, 0.5), random.rangeF(-0.5, 0.5)});
    const Table table = fill(256, positions);
    std::size_t wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::vec3 a(random.rangeF(-3, 3), random.rangeF(-3, 3), 1);
        const glm::vec3 b(random.rangeF(-3, 3), random.rangeF(-3, 3), 1);
        const glm::uvec4 found = edgeMask(table, 256, a, b, 64);
        for (unsigned s = 0; s < 64; ++s) {
            const glm::dvec2 p = positions[s], d = glm::dvec2(b) - glm::dvec2(a), e = p - glm::dvec2(a);
            wrong += (d.x * e.y - d.y * e.x > 0) != math_f::agaa_isCovered(found, s);
        }
    }
    EXPECT_LT(double(wrong), 20000.0 * 64 * 0.003);
}

} // namespace
