// Points in triangles: what weights must do, float against double over random and extreme triangles, and slivers.
#include "test_support.h"

#include <algorithm>

using namespace test_math;

namespace {

const glm::dvec2 pixels(320, 180); // per ndc

struct Triangle {
    glm::dvec3 clip[3]; // x, y, w
};

math_d::agaa_Barycentrics exact(const Triangle& t, glm::dvec2 ndc) {
    return math_d::agaa_barycentrics(t.clip[0], t.clip[1], t.clip[2], ndc, pixels);
}

math_f::agaa_Barycentrics single(const Triangle& t, glm::dvec2 ndc) {
    return math_f::agaa_barycentrics(glm::vec3(t.clip[0]), glm::vec3(t.clip[1]), glm::vec3(t.clip[2]), glm::vec2(ndc),
                                     glm::vec2(pixels));
}

// Values that floats hold, so that both precisions are given the same triangle.
Triangle rounded(Triangle t) {
    for (glm::dvec3& v : t.clip)
        v = glm::dvec3(glm::vec3(v));
    return t;
}

// A triangle about `extent` pixels wide around a point of the image, seen at depths around w.
Triangle randomTriangle(Random& random, glm::dvec2 ndc, double extent, double w) {
    Triangle t;
    for (glm::dvec3& v : t.clip) {
        const double own = w * random.decades(0.9, 1.1);
        const glm::dvec2 at = ndc + extent * glm::dvec2(random.range(-1, 1), random.range(-1, 1)) / pixels;
        v = glm::dvec3(at * own, own);
    }
    return rounded(t);
}

double sum(glm::dvec3 v) { return v.x + v.y + v.z; }

bool isInside(const Triangle& t, glm::dvec2 ndc) {
    glm::dvec3 edge;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = t.clip[(i + 1) % 3], b = t.clip[(i + 2) % 3];
        const glm::dvec2 ra = glm::dvec2(a) - ndc * a.z, rb = glm::dvec2(b) - ndc * b.z;
        edge[i] = ra.x * rb.y - ra.y * rb.x;
    }
    return (edge.x > 0 && edge.y > 0 && edge.z > 0) || (edge.x < 0 && edge.y < 0 && edge.z < 0);
}

// What float may be off by: the rounding of distances to the ray, of coordinates far from it, by the area.
double bound(const Triangle& t, glm::dvec2 ndc) {
    double r = 0, coordinate = 0, area = 0;
    glm::dvec2 ray[3];
    for (int i = 0; i < 3; ++i) {
        ray[i] = (glm::dvec2(t.clip[i]) - ndc * t.clip[i].z) * pixels;
        r = std::max(r, glm::length(ray[i]));
        coordinate = std::max({coordinate, std::fabs(t.clip[i].x) * pixels.x, std::fabs(t.clip[i].y) * pixels.y,
                               std::fabs(t.clip[i].z) * pixels.x});
    }
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 a = ray[i], b = ray[(i + 1) % 3];
        area += a.x * b.y - a.y * b.x;
    }
    return 0x1p-23 * (8 * r * (coordinate + r) / std::fabs(area) + 4);
}

} // namespace

TEST(MathBarycentrics, GiveThePointBack) {
    Random random(3);
    for (int i = 0; i < 100000; ++i) {
        const glm::dvec2 ndc(random.range(-1, 1), random.range(-1, 1));
        const Triangle t = randomTriangle(random, ndc, random.decades(0.1, 1000), random.decades(0.01, 1e4));
        if (!isInside(t, ndc))
            continue;
        const auto b = exact(t, ndc);
        ASSERT_NEAR(sum(b.at), 1, 1e-12);
        ASSERT_NEAR(sum(b.dx), 0, 1e-9 * (1 + glm::length(b.dx)));
        const glm::dvec3 p = b.at.x * t.clip[0] + b.at.y * t.clip[1] + b.at.z * t.clip[2];
        ASSERT_NEAR(p.x / p.z, ndc.x, 1e-9);
        ASSERT_NEAR(p.y / p.z, ndc.y, 1e-9);
        ASSERT_GT(p.z, 0);
    }
}

TEST(MathBarycentrics, DerivativesAreDifferences) {
    Random random(5);
    int checked = 0;
    while (checked < 20000) {
        const glm::dvec2 ndc(random.range(-1, 1), random.range(-1, 1));
        const Triangle t = randomTriangle(random, ndc, random.decades(2, 1000), random.decades(0.01, 1e4));
        const double step = 1e-4; // of a pixel
        const glm::dvec2 x = ndc + glm::dvec2(step / pixels.x, 0), y = ndc + glm::dvec2(0, step / pixels.y);
        if (!isInside(t, ndc) || !isInside(t, x) || !isInside(t, y))
            continue;
        const auto b = exact(t, ndc);
        const glm::dvec3 dx = (exact(t, x).at - b.at) / step, dy = (exact(t, y).at - b.at) / step;
        ASSERT_LT(glm::length(dx - b.dx), 1e-3 * glm::length(b.dx) + 1e-7);
        ASSERT_LT(glm::length(dy - b.dy), 1e-3 * glm::length(b.dy) + 1e-7);
        ++checked;
    }
}

TEST(MathBarycentrics, FloatIsAsGoodAsItsInput) {
    Random random(7);
    double worst = 0;
    for (int i = 0; i < 300000; ++i) {
        const glm::dvec2 ndc = glm::dvec2(glm::vec2(glm::dvec2(random.range(-1, 1), random.range(-1, 1))));
        const Triangle t = randomTriangle(random, ndc, random.decades(0.01, 1e5), random.decades(1e-6, 1e9));
        if (!isInside(t, ndc))
            continue;
        const auto d = exact(t, ndc);
        const auto f = single(t, ndc);
        const double most = bound(t, ndc);
        const double error = glm::length(glm::dvec3(f.at) - d.at);
        ASSERT_LE(error, most) << "extents and depths over " << i;
        worst = std::max(worst, error / most);
        if (most < 0.1) {
            ASSERT_EQ(f.facing > 0, d.facing > 0);
            ASSERT_LE(glm::length(glm::dvec3(f.dx) - d.dx),
                      4 * most * (1 + glm::length(d.dx)) * (1 + glm::length(d.dx) + glm::length(d.dy)));
        }
    }
    std::printf("largest error %.3f of the bound\n", worst);
}

// Half of the triangle lies behind the eye; what is before it has the weights of the part that a clipper leaves.
TEST(MathBarycentrics, VerticesBehindTheEye) {
    Random random(11);
    int checked = 0;
    while (checked < 20000) {
        Triangle t;
        for (glm::dvec3& v : t.clip)
            v = {random.range(-10, 10), random.range(-10, 10), random.range(-10, 10)};
        t = rounded(t);
        // A point of it, by weights.
        glm::dvec3 at(random.unit(), random.unit(), random.unit());
        at /= sum(at);
        const glm::dvec3 p = at.x * t.clip[0] + at.y * t.clip[1] + at.z * t.clip[2];
        if (p.z < 0.1 || std::fabs(p.x) > p.z || std::fabs(p.y) > p.z)
            continue;
        const glm::dvec2 ndc = glm::dvec2(p) / p.z;
        if (bound(t, ndc) > 1e-3)
            continue;
        ++checked;
        ASSERT_LT(glm::length(exact(t, ndc).at - at), 1e-9);
        ASSERT_LT(glm::length(glm::dvec3(single(t, ndc).at) - at), 1e-3);
    }
}

TEST(MathBarycentrics, SliversAndPointsBesideStayInside) {
    Random random(13);
    const float extremes[] = {0, 1, -1, 1e-30f, 1e30f, -1e30f, 1e-20f, 3e38f, 0.5f};
    for (int i = 0; i < 200000; ++i) {
        glm::vec3 clip[3];
        for (glm::vec3& v : clip)
            for (int k = 0; k < 3; ++k)
                v[k] = i % 2 ? extremes[random.below(9)] : random.rangeF(-1, 1) * (k ? 1.0f : 1e-4f);
        const glm::vec2 ndc(random.rangeF(-1, 1), random.rangeF(-1, 1));
        const auto b = math_f::agaa_barycentrics(clip[0], clip[1], clip[2], ndc, glm::vec2(pixels));
        for (int k = 0; k < 3; ++k) {
            ASSERT_GE(b.at[k], 0.0f);
            ASSERT_LE(b.at[k], 1.0f);
            ASSERT_TRUE(std::isfinite(b.dx[k]) && std::isfinite(b.dy[k])) << i;
        }
        ASSERT_NEAR(b.at.x + b.at.y + b.at.z, 1.0f, 1e-5f);
        ASSERT_TRUE(std::isfinite(b.facing));
    }
}

TEST(MathBarycentrics, FacingIsThatOfTheOutline) {
    const Triangle t = {{{-0.1, -0.1, 1}, {0.2, 0, 2}, {0, 0.3, 3}}};
    EXPECT_GT(exact(t, {0, 0}).facing, 0);
    const Triangle turned = {{t.clip[1], t.clip[0], t.clip[2]}};
    EXPECT_LT(exact(turned, {0, 0}).facing, 0);
}
