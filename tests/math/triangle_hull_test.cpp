// Expansion of triangles for rasterisation (src/shaders/math/triangle_hull.glsl).
#include "coverage_oracle.h"

using namespace test_math;

namespace {

constexpr glm::dvec2 halfSize(64, 48); // of an image of 128 x 96 pixels
const glm::vec2 pixelsPerNdc(halfSize);

// The outline of a strip in pixels from the image's middle, anticlockwise.
Polygon outlineOf(const math_f::agaa_Hull& hull) {
    Polygon p;
    std::vector<unsigned> order;
    for (unsigned i = 1; i < hull.count; i += 2)
        order.push_back(i);
    for (unsigned i = (hull.count - 1) / 2 * 2; i > 0; i -= 2)
        order.push_back(i);
    order.insert(order.begin(), 0);
    for (const unsigned i : order)
        p.push_back(glm::dvec2(hull.vertices[i].x, hull.vertices[i].y) * halfSize);
    return p;
}

double depthInside(const Polygon& outline, const glm::dvec2& point) {
    double least = 1e30;
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const glm::dvec2 d = outline[(k + 1) % outline.size()] - outline[k], e = point - outline[k];
        if (glm::length(d) > 1e-9)
            least = std::min(least, (d.x * e.y - d.y * e.x) / glm::length(d));
    }
    return least;
}

glm::vec4 inClip(const glm::dvec2& pixels, double w, bool reversed) {
    return clipVertex(pixels / halfSize, w, reversed ? glm::dvec2(-1, 1) : glm::dvec2(1, 0));
}

void check(const Clip& t, bool reversed, double& worstExcess, std::size_t& touched) {
    const glm::vec2 nearPlane = reversed ? glm::vec2(-1, 1) : glm::vec2(1, 0);
    const Polygon triangle = projected(t, glm::dvec2(nearPlane), halfSize);
    const math_f::agaa_Hull hull = math_f::agaa_triangleHull(t[0], t[1], t[2], nearPlane, pixelsPerNdc);
    ASSERT_LE(hull.count, 8u);
    if (triangle.empty()) {
        EXPECT_EQ(hull.count, 0u);
        return;
    }
    ASSERT_GE(hull.count, 4u);
    const Polygon outline = outlineOf(hull);
    glm::dvec2 low(1e30), high(-1e30);
    for (const glm::dvec2& p : triangle) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const double size = std::max({std::abs(low.x), std::abs(low.y), std::abs(high.x), std::abs(high.y)});
    // The area of the sum of a convex polygon and a square of width 1.
    const double exact = areaOf(triangle) + (high.x - low.x) + (high.y - low.y) + 1;
    if (size < 2000)
        worstExcess = std::max(worstExcess, areaOf(outline) / exact - 1);
    if (size < 1e6) {
        EXPECT_GE(areaOf(outline), exact);
    }
    const glm::dvec2 first = glm::floor(glm::max(low - 1.0, -halfSize)), last = glm::min(high + 1.0, halfSize);
    for (double y = first.y + 0.5; y < last.y; ++y)
        for (double x = first.x + 0.5; x < last.x; ++x)
            if (touches(triangle, {x, y})) {
                ++touched;
                ASSERT_GT(depthInside(outline, {x, y}), 1.0 / 512) << x << " " << y;
            }
}

TEST(TriangleHull, ContainsTheCentreOfEveryTouchedPixel) {
    Random random(1);
    double excess = 0;
    std::size_t touched = 0;
    for (int i = 0; i < 20000; ++i) {
        const double size = random.decades(0.01, 30), thin = i % 3 == 0 ? random.decades(1e-9, 0.1) : 1;
        const double turn = i % 5 == 0 ? random.below(8) * 0.7853981633974483 : random.range(0, 6.3);
        const glm::dvec2 at(random.range(-60, 60), random.range(-45, 45)), d(std::cos(turn), std::sin(turn));
        Clip t;
        for (glm::vec4& v : t) {
            const double along = size * random.range(-1, 1), aside = size * thin * random.range(-1, 1);
            v = inClip(at + along * d + aside * glm::dvec2(-d.y, d.x), random.decades(0.2, 50), i % 2 != 0);
        }
        if (i % 50 == 0)
            t[1] = t[0];
        if (i % 100 == 0)
            t[2] = t[0];
        check(t, i % 2 != 0, excess, touched);
        if (HasFatalFailure())
            return;
    }
    std::printf("[ measured ] area beyond the exact sum %.2f %%, %zu pixels\n", 100 * excess, touched);
    EXPECT_LT(excess, 0.06);
    EXPECT_GT(touched, 100000u);
}

// Hard case 50: near the eye plane, with projected vertices up to millions of pixels away.
TEST(TriangleHull, TrianglesThroughTheEyePlane) {
    Random random(50);
    double excess = 0;
    std::size_t touched = 0;
    unsigned quads = 0;
    for (int i = 0; i < 600; ++i) {
        Clip t;
        for (glm::vec4& v : t) {
            const double w = random.range(-4, 6), spread = random.decades(20, i % 4 ? 300 : 1e5);
            v = inClip({0, 0}, w, i % 2 != 0);
            v.x = float(random.range(-1, 1) * spread / halfSize.x);
            v.y = float(random.range(-1, 1) * spread / halfSize.y);
        }
        // A vertex just behind the near plane: the two points of its edges on the plane hardly differ.
        if (i % 3 == 0)
            for (std::size_t k = 0; k < 3; ++k) {
                const double w = k == 1 ? 0.1 - random.decades(1e-9, 1e-3) : random.range(0.2, 2);
                t[k] = inClip({random.range(-90, 90), random.range(-70, 70)}, w, i % 2 != 0);
            }
        check(t, i % 2 != 0, excess, touched);
        if (HasFatalFailure())
            return;
        const glm::vec2 nearPlane = i % 2 ? glm::vec2(-1, 1) : glm::vec2(1, 0);
        quads += math_f::agaa_triangleHull(t[0], t[1], t[2], nearPlane, pixelsPerNdc).count == 8;
    }
    EXPECT_GT(quads, 80u);
    EXPECT_GT(touched, 100000u);
}

TEST(TriangleHull, ShapesAreAsSmallAsTheyCanBe) {
    const auto count = [](const Clip& t) {
        return math_f::agaa_triangleHull(t[0], t[1], t[2], {1, 0}, pixelsPerNdc).count;
    };
    const auto at = [](double x, double y) { return inClip({x, y}, 1, false); };
    EXPECT_EQ(count({at(0, 0), at(10, 3), at(4, 12)}), 7u);
    EXPECT_EQ(count({at(0, 0), at(10, 3), at(20, 6)}), 6u); // a line
    EXPECT_EQ(count({inClip({0, 0}, -1, false), inClip({1, 0}, -1, false), inClip({0, 1}, 0.05, false)}), 0u);
    // A vertex at the eye, which no near plane cut off: the whole image.
    const glm::vec4 eye(0, 0, 1, 0);
    EXPECT_EQ(count({eye, at(1, 2), at(3, 4)}), 4u);
    for (int k = 0; k < 4; ++k)
        for (const float bad : {nanF(), infinityF(), -infinityF()}) {
            glm::vec4 v = at(3, 4);
            v[k] = bad;
            EXPECT_EQ(count({at(0, 0), at(1, 2), v}), 0u);
        }
}

} // namespace
