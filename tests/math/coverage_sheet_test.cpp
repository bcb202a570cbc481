// Tessellated sheets: every sample belongs to exactly one triangle (hard cases 47 and 50).
#include <algorithm>

#include "coverage_oracle.h"

using namespace test_math;

namespace {

// A grid of cells, each split into two triangles along a random diagonal.
struct Sheet {
    unsigned columns, rows;
    std::vector<glm::vec3> vertices;
    std::vector<Vertices> triangles;

    template <class Place> Sheet(Random& random, unsigned c, unsigned r, const Place& place) : columns(c), rows(r) {
        for (unsigned y = 0; y <= rows; ++y)
            for (unsigned x = 0; x <= columns; ++x)
                vertices.push_back(place(x, y));
        const auto at = [&](unsigned x, unsigned y) { return vertices[y * (columns + 1) + x]; };
        for (unsigned y = 0; y < rows; ++y)
            for (unsigned x = 0; x < columns; ++x) {
                const glm::vec3 a = at(x, y), b = at(x + 1, y), e = at(x, y + 1), f = at(x + 1, y + 1);
                // Both windings occur.
                if (random.below(2) == 0)
                    triangles.insert(triangles.end(), {Vertices{a, b, f}, Vertices{a, f, e}});
                else
                    triangles.insert(triangles.end(), {Vertices{b, a, e}, Vertices{b, f, e}});
            }
    }

    // For each sample of a pixel the number of triangles that cover it.
    std::vector<unsigned> layers(const glm::vec2& centre, unsigned samples) const {
        std::vector<unsigned> count(samples, 0);
        for (const Vertices& t : triangles) {
            const glm::uvec4 mask = math_f::agaa_triangleCoverage(t[0], t[1], t[2], centre, samples);
            if (mask != glm::uvec4(0))
                for (unsigned i = 0; i < samples; ++i)
                    count[i] += math_f::agaa_isCovered(mask, i) ? 1u : 0u;
        }
        return count;
    }
};

// Of the pixels of a square that lies inside the sheet.
std::size_t wrongSamples(const Sheet& sheet, const glm::ivec2& first, int size, unsigned samples) {
    std::size_t wrong = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (const unsigned count : sheet.layers(glm::vec2(first + glm::ivec2(x, y)) + 0.5f, samples))
                wrong += count != 1;
    return wrong;
}

// The cells are about 1.5 pixels wide; the border lies outside the 4 x 4 pixels.
glm::dvec2 jittered(Random& random, unsigned x, unsigned y, const glm::ivec2& first, double amplitude) {
    return glm::dvec2(first) - 2.0 +
           1.5 * glm::dvec2(x + random.range(-amplitude, amplitude), y + random.range(-amplitude, amplitude));
}

TEST(CoverageSheet, JitteredVertices) {
    Random random(1);
    std::size_t wrong = 0;
    for (int i = 0; i < 240; ++i) {
        const glm::ivec2 first(random.below(16000), random.below(16000));
        const bool level = i % 5 == 0; // rows and columns of the grid stay straight
        const Sheet sheet(random, 6, 6, [&](unsigned x, unsigned y) {
            const glm::dvec2 p = jittered(random, x, y, first, level ? 0 : 0.25);
            return vertex(p.x, p.y, i % 2 ? 1 : random.decades(0.1, 10));
        });
        wrong += wrongSamples(sheet, first, 4, std::array{32u, 64u, 128u}[static_cast<std::size_t>(i % 3)]);
    }
    EXPECT_EQ(wrong, 0u);
}

// All vertices are at sample positions, so that edges, too, often pass through samples.
TEST(CoverageSheet, VerticesOnSamples) {
    Random random(2);
    std::size_t wrong = 0;
    for (int i = 0; i < 240; ++i) {
        const unsigned samples = std::array{32u, 64u, 128u}[static_cast<std::size_t>(i % 3)];
        const glm::ivec2 first(random.below(i % 2 ? 16000 : 100), random.below(8000));
        const Sheet sheet(random, 6, 6, [&](unsigned x, unsigned y) {
            const glm::dvec2 p = jittered(random, x, y, first, 0.2);
            glm::dvec2 best(0);
            for (unsigned s = 0; s < samples; ++s) {
                const glm::dvec2 q = glm::floor(p) + 0.5 + math_d::agaa_coveragePosition(s, samples);
                if (s == 0 || glm::distance(p, q) < glm::distance(p, best))
                    best = q;
            }
            return vertex(best.x, best.y, i % 4 < 2 ? 1 : std::array{0.25, 1.0, 2.0}[random.below(3)]);
        });
        wrong += wrongSamples(sheet, first, 4, samples);
    }
    EXPECT_EQ(wrong, 0u);
}

// Fans of long triangles whose common vertex is on a sample.
TEST(CoverageSheet, LongFansAroundASample) {
    Random random(3);
    std::size_t wrong = 0;
    for (int i = 0; i < 3000; ++i) {
        const unsigned samples = std::array{32u, 64u, 128u}[static_cast<std::size_t>(i % 3)];
        const glm::dvec2 centre(random.below(4000) + 0.5, random.below(4000) + 0.5);
        const glm::dvec2 hub = centre + math_d::agaa_coveragePosition(random.below(samples), samples);
        const glm::vec3 middle = vertex(hub.x, hub.y);
        const unsigned spokes = i % 2 ? 8 : 3 + random.below(8);
        std::vector<glm::vec3> rim;
        for (unsigned k = 0; k < spokes; ++k) {
            const double angle = 6.283185307179586 * (k + (i % 2 ? 0 : random.range(-0.2, 0.2))) / spokes;
            const double reach = random.decades(8, 4000);
            glm::dvec2 p = hub + reach * glm::dvec2(std::cos(angle), std::sin(angle));
            if (i % 2) // level, upright and diagonal spokes
                p = hub + std::round(reach) * glm::round(glm::dvec2(std::cos(angle), std::sin(angle)));
            rim.push_back(vertex(p.x, p.y));
        }
        std::vector<unsigned> count(samples, 0);
        for (unsigned k = 0; k < spokes; ++k) {
            const glm::uvec4 mask =
                math_f::agaa_triangleCoverage(middle, rim[k], rim[(k + 1) % spokes], glm::vec2(centre), samples);
            for (unsigned s = 0; s < samples; ++s)
                count[s] += math_f::agaa_isCovered(mask, s) ? 1u : 0u;
        }
        // The rim may cut through the pixel: only the neighbourhood of the hub is sure to be inside.
        for (unsigned s = 0; s < samples; ++s)
            if (glm::distance(centre + math_d::agaa_coveragePosition(s, samples), hub) < 0.3)
                wrong += count[s] != 1;
    }
    EXPECT_EQ(wrong, 0u);
}

// A plane seen in perspective that reaches behind the eye. Samples see it once, or not at all above its horizon.
TEST(CoverageSheet, VerticesBehindTheEye) {
    Random random(4);
    std::size_t wrong = 0, seen = 0, above = 0, behind = 0;
    for (int i = 0; i < 120; ++i) {
        const glm::dvec2 middle(random.below(1900), random.below(1000));
        // Columns: directions of the sheet and its origin, in (x w, y w, w).
        const double turn = random.range(0, 6.283);
        const glm::dvec3 u(40 * std::cos(turn), 40 * std::sin(turn), random.range(-1, 1));
        const glm::dvec3 v(-40 * std::sin(turn), 40 * std::cos(turn), random.range(-1, 1));
        const glm::dmat3 toLocal(u, v, glm::dvec3(random.range(-9, 9), random.range(-9, 9), 1));
        const glm::dmat3 toSheet = glm::inverse(toLocal);
        const Sheet sheet(random, 8, 8, [&](unsigned x, unsigned y) {
            const glm::dvec2 cell(x + random.range(-0.25, 0.25) - 4.0, y + random.range(-0.25, 0.25) - 4.0);
            const glm::dvec3 local = toLocal * glm::dvec3(cell, 1);
            behind += local.z < 0;
            return glm::vec3(local.x + middle.x * local.z, local.y + middle.y * local.z, local.z);
        });
        for (int pixel = 0; pixel < 40; ++pixel) {
            const glm::dvec2 centre =
                glm::floor(middle + glm::dvec2(random.range(-60, 60), random.range(-60, 60))) + 0.5;
            const std::vector<unsigned> count = sheet.layers(glm::vec2(centre), 64);
            for (unsigned s = 0; s < 64; ++s) {
                const glm::dvec3 at = toSheet * glm::dvec3(centre + math_d::agaa_coveragePosition(s, 64) - middle, 1);
                if (at.z < -1e-4) {
                    wrong += count[s] != 0;
                    ++above;
                } else if (at.z > 1e-4 && std::max(std::abs(at.x), std::abs(at.y)) < 3.5 * at.z) {
                    wrong += count[s] != 1;
                    ++seen;
                }
            }
        }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(seen, 50000u);
    EXPECT_GT(above, 20000u);
    EXPECT_GT(behind, 1000u);
}

} // namespace
