// Which pattern of coverage samples estimates covered areas best: why coverage_pattern.glsl has the patterns it has.
//
// The error is the mean square of (covered samples / samples - covered area) over random shapes that cover a part of
// the pixel. A row of C equally spaced samples can enter an edge parallel to it all at once, so rows must be short; a
// half-plane costs one span per row. Rank-1 lattices are traversed along their lines, whose numbers of samples differ.
#include "coverage_oracle.h"

using namespace test_math;

namespace {

using Pattern = std::vector<glm::dvec2>;

struct Shape {
    std::vector<glm::dvec3> lines; // a x + b y + c >= 0
    double area = 0;
};

enum Kind { anyEdge, levelEdge, uprightEdge, strip, levelStrip, triangle, kinds };
constexpr std::array<const char*, kinds> names = {"edges", "level", "upright", "strips", "axis strips", "triangles"};

glm::dvec3 lineAt(double angle, double distance) { return {std::cos(angle), std::sin(angle), -distance}; }

Shape draw(Random& random, Kind kind) {
    constexpr double turn = 6.283185307179586, fiveDegrees = turn / 72;
    for (;;) {
        Shape s;
        double angle = random.range(0, turn);
        if (kind == levelEdge || kind == uprightEdge)
            angle = (kind == levelEdge ? turn / 4 : 0) + random.range(-fiveDegrees, fiveDegrees) +
                    (random.below(2) ? turn / 2 : 0);
        if (kind == levelStrip)
            angle = random.below(2) * turn / 4 + random.range(-fiveDegrees, fiveDegrees);
        if (kind == triangle) {
            const double size = random.decades(0.1, 2);
            const glm::dvec2 at(random.range(-0.7, 0.7), random.range(-0.7, 0.7));
            std::array<glm::dvec3, 3> v;
            for (glm::dvec3& p : v)
                p = {at.x + size * random.range(-0.5, 0.5), at.y + size * random.range(-0.5, 0.5), 1};
            const double sign = det(v[0], v[1], v[2]) < 0 ? -1 : 1;
            for (std::size_t k = 0; k < 3; ++k)
                s.lines.push_back(sign * glm::cross(v[k], v[(k + 1) % 3]));
        } else {
            const bool thin = kind == strip || kind == levelStrip;
            const double distance = random.range(-1, 1) * (thin ? 1.25 : 0.75);
            s.lines.push_back(lineAt(angle, distance));
            if (thin)
                s.lines.push_back(-lineAt(angle, distance + random.decades(0.02, 1)));
        }
        Polygon p = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
        for (const glm::dvec3& line : s.lines)
            p = clipped(p, line);
        s.area = areaOf(p);
        if (s.area > 0 && (s.area < 1 || s.lines.size() > 1))
            return s;
    }
}

double meanSquare(const Pattern& pattern, const std::vector<Shape>& shapes) {
    double sum = 0;
    for (const Shape& s : shapes) {
        unsigned covered = 0;
        for (const glm::dvec2& p : pattern) {
            bool in = true;
            for (const glm::dvec3& l : s.lines)
                in &= l.x * p.x + l.y * p.y + l.z >= 0;
            covered += in;
        }
        const double error = double(covered) / double(pattern.size()) - s.area;
        sum += error * error;
    }
    return sum / double(shapes.size());
}

template <class Position> Pattern make(unsigned n, const Position& position) {
    Pattern p;
    for (unsigned i = 0; i < n; ++i)
        p.push_back(position(i) - 0.5);
    return p;
}

Pattern chosen(unsigned n) {
    return make(n, [n](unsigned i) { return math_d::agaa_coveragePosition(i, n) + 0.5; });
}

// The usual four rotated samples in each cell of a grid.
Pattern rotatedCells(unsigned columns, unsigned rows) {
    constexpr std::array<std::array<double, 2>, 4> cell = {{{6, 2}, {14, 6}, {2, 10}, {10, 14}}};
    return make(4 * columns * rows, [=](unsigned i) {
        const unsigned c = i / 4;
        return glm::dvec2((c % columns + cell[i % 4][0] / 16) / columns, (c / columns + cell[i % 4][1] / 16) / rows);
    });
}

// Eight rows of eight, sheared by one step along x and one step along y. With the same sign these stretch the pattern
// along one diagonal: two corners of the pixel hold no samples. With opposite signs they turn it.
Pattern skewed(bool turned) {
    return make(64, [=](unsigned i) {
        const unsigned c = i % 8, r = i / 8;
        return glm::dvec2(8 * c + (turned ? 7 - r : r) + 0.5, 8 * r + c + 0.5) / 64.0;
    });
}

// Rows at y = (r + 1/2) / rows with phase `step` * r, each sample `rise` / 64 above the one before.
Pattern rowsOf(unsigned columns, unsigned rows, double step, double rise = 0) {
    return make(columns * rows, [=](unsigned i) {
        const unsigned c = i % columns, r = i / columns;
        const double phase = step * r + 0.5 / rows;
        return glm::dvec2((c + phase - std::floor(phase)) / columns,
                          (r + 0.5) / rows + rise * (c - (columns - 1) / 2.0) / 64);
    });
}

Pattern rankOneLattice(unsigned n, unsigned k) {
    return make(n, [=](unsigned i) { return glm::dvec2(i + 0.5, k * i % n + 0.5) / double(n); });
}

class CoveragePatterns : public testing::Test {
protected:
    static constexpr int draws = 50000;
    std::array<std::vector<Shape>, kinds> shapes;

    void SetUp() override {
        Random random(64);
        for (int k = 0; k < kinds; ++k)
            for (int i = 0; i < draws; ++i)
                shapes[static_cast<std::size_t>(k)].push_back(draw(random, Kind(k)));
        std::printf("%-36s %5s", "mean square error, 1e-5", "spans");
        for (const char* name : names)
            std::printf(" %11s", name);
        std::printf("\n");
    }

    std::array<double, kinds> report(const char* name, unsigned spans, const Pattern& p) {
        std::array<double, kinds> e{};
        std::printf("%3zu %-32s %5u", p.size(), name, spans);
        for (std::size_t k = 0; k < kinds; ++k)
            std::printf(" %11.2f", 1e5 * (e[k] = meanSquare(p, shapes[k])));
        std::printf("\n");
        return e;
    }

    // The error of each kind of shape as a multiple of the reference's.
    static void expectAtMost(const std::array<double, kinds>& e, const std::array<double, kinds>& reference,
                             const std::array<double, kinds>& factor) {
        for (std::size_t k = 0; k < kinds; ++k)
            EXPECT_LE(e[k], reference[k] * factor[k]) << names[k];
    }
};

TEST_F(CoveragePatterns, SixtyFourSamples) {
    const auto cells = report("4 x 4 rotated cells", 64, rotatedCells(4, 4));
    const auto ours = report("chosen: 16 rows of 4, phase 7/16", 16, chosen(64));
    const auto sheared = report("8 rows of 8, sheared both ways", 8, skewed(false));
    report("8 rows of 8, turned", 8, skewed(true));
    report("8 rows of 8, phase 5/8", 8, rowsOf(8, 8, 5 / 8.0));
    const auto tilted = report("8 rows of 8, phase 3/8, tilted", 8, rowsOf(8, 8, 3 / 8.0, -1));
    report("16 rows of 4, phase 9/16, tilted", 16, rowsOf(4, 16, 9 / 16.0, -1));
    report("rank-1 lattice, k = 19", 10, rankOneLattice(64, 19));
    report("rank-1 lattice, k = 27", 10, rankOneLattice(64, 27));
    expectAtMost(ours, cells, {1.02, 1.05, 0.65, 1.02, 0.85, 0.95});
    EXPECT_GT(sheared[anyEdge], 2.5 * ours[anyEdge]);
    EXPECT_GT(tilted[levelEdge], 1.3 * ours[levelEdge]);
}

TEST_F(CoveragePatterns, ThirtyTwoAndHundredAndTwentyEightSamples) {
    const auto cells32 = report("4 x 2 rotated cells", 32, rotatedCells(4, 2));
    const auto ours32 = report("chosen: 16 rows of 2, phase 5/16", 16, chosen(32));
    report("8 rows of 4, phase 5/8", 8, rowsOf(4, 8, 5 / 8.0));
    report("8 rows of 4, phase 3/8, tilted", 8, rowsOf(4, 8, 3 / 8.0, -2));
    const auto cells128 = report("8 x 4 rotated cells", 128, rotatedCells(8, 4));
    const auto ours128 = report("chosen: 32 rows of 4, phase 41/64", 32, chosen(128));
    report("16 rows of 8, phase 7/16", 16, rowsOf(8, 16, 7 / 16.0));
    expectAtMost(ours32, cells32, {1.15, 0.35, 1.25, 1.12, 0.5, 1.05});
    expectAtMost(ours128, cells128, {1.06, 0.3, 1.05, 1.05, 0.4, 1.0});
}

} // namespace
