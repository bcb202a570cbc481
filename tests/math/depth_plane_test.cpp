// Depth planes of triangles (src/shaders/math/depth_plane.glsl).
#include "coverage_oracle.h"

using namespace test_math;

namespace {

struct Triangle {
    Vertices at;
    glm::vec3 z;
};

// Depth z / w at a point, in double.
double trueDepth(const Triangle& t, const glm::dvec2& point) {
    const glm::dvec3 a = atPoint(t.at[0], point), b = atPoint(t.at[1], point), c = atPoint(t.at[2], point);
    const glm::dvec3 e(glm::cross(b, c).z, glm::cross(c, a).z, glm::cross(a, b).z);
    return glm::dot(e, glm::dvec3(t.z)) / glm::dot(e, glm::dvec3(a.z, b.z, c.z));
}

math_f::agaa_DepthPlane planeOf(const Triangle& t, const glm::vec2& centre) {
    return math_f::agaa_depthPlane(t.at[0], t.at[1], t.at[2], t.z, centre);
}

// A projection with the near plane at w = 0.1; depth 0 is there, or 1 where reversed.
float clipZ(double w, bool reversed) {
    const double standard = (w - 0.1) * 1.0001;
    return float(reversed ? w - standard : standard);
}

Triangle place(const std::array<glm::dvec3, 3>& xyw, bool reversed) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
        t.at[k] = vertex(xyw[k].x, xyw[k].y, xyw[k].z);
        t.z[static_cast<int>(k)] = clipZ(double(t.at[k].z), reversed);
    }
    return t;
}

TEST(DepthPlane, FloatAgreesWithTheOracle) {
    Random random(1);
    Worst small("depth, triangles of a few pixels, + 2e-6 pixels of slope", 2e-7),
        large("depth, triangles of many pixels, + 2e-6 pixels of slope", 4e-7),
        inside("covered samples outside the interval", 2e-7);
    std::size_t covered = 0, flattened = 0;
    for (int i = 0; i < 100000; ++i) {
        const bool big = i % 2 != 0;
        const double size = big ? random.decades(4, 4000) : random.decades(0.1, 4), w = random.decades(0.2, 500);
        const glm::dvec2 at(random.range(0, 16384), random.range(0, 16384));
        std::array<glm::dvec3, 3> v;
        for (glm::dvec3& p : v)
            p = {at.x + size * random.range(-1, 1), at.y + size * random.range(-1, 1), w * random.decades(0.5, 2)};
        const Triangle t = place(v, i % 4 < 2);
        const glm::vec2 centre(glm::floor(at) + 0.5);
        const math_f::agaa_DepthPlane plane = planeOf(t, centre);
        for (unsigned s = 0; s < 64; s += 3) {
            const glm::dvec2 offset = math_d::agaa_coveragePosition(s, 64);
            if (!contains(t.at, glm::dvec2(centre) + offset))
                continue;
            const double depth = trueDepth(t, glm::dvec2(centre) + offset);
            const double error = std::abs(double(math_f::agaa_depthAt(plane, glm::vec2(offset))) - depth);
            const double slope = double(std::abs(plane.slope.x) + std::abs(plane.slope.y));
            const glm::dvec3 depths = glm::dvec3(t.z) / glm::dvec3(t.at[0].z, t.at[1].z, t.at[2].z);
            const double range = std::max({depths.x, depths.y, depths.z}) - std::min({depths.x, depths.y, depths.z});
            ++covered;
            EXPECT_LE(double(plane.range.y - plane.range.x), slope + 2e-7); // no wider than the plane in the pixel
            if (slope > 0.999 * double(math_f::agaa_steepestSlope()) * range) {
                ++flattened;
                EXPECT_LE(error, range);
                continue;
            }
            (big ? large : small).add(std::max(0.0, error - 2e-6 * slope));
            inside.add(std::max({0.0, double(plane.range.x) - depth, depth - double(plane.range.y)}));
        }
    }
    EXPECT_GT(covered, 20000u);
    EXPECT_LT(double(flattened), 1e-3 * double(covered));
}

// Hard case 45: the plane equation in absolute pixels, as the paper prints it, loses digits and leaves the triangle.
TEST(DepthPlane, TheEquationInAbsolutePixelsIsWorse) {
    Random random(45);
    double printed = 0, ours = 0;
    std::size_t outside = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec2 at(random.range(0, 16384), random.range(0, 16384));
        const bool edgeOn = i % 2 != 0;
        const double thickness = edgeOn ? 1e-3 : 1;
        std::array<glm::dvec3, 3> v = {glm::dvec3(at, 0.2), glm::dvec3(at.x + 30, at.y + 3, 0.21),
                                       glm::dvec3(at.x + 15, at.y + 1.5 + 20 * thickness, 0.3)};
        const Triangle t = place(v, false);
        const glm::vec3 p(t.at[0].x / t.at[0].z, t.at[0].y / t.at[0].z, t.z.x / t.at[0].z),
            q(t.at[1].x / t.at[1].z, t.at[1].y / t.at[1].z, t.z.y / t.at[1].z),
            r(t.at[2].x / t.at[2].z, t.at[2].y / t.at[2].z, t.z.z / t.at[2].z);
        const glm::vec3 n = glm::cross(q - p, r - p);
        const glm::vec2 centre(glm::floor(at + glm::dvec2(15, edgeOn ? 1.5 : 5)) + 0.5);
        const float naive = -(n.x * centre.x + n.y * centre.y - glm::dot(n, p)) / n.z;
        const float least = std::min({p.z, q.z, r.z}), greatest = std::max({p.z, q.z, r.z});
        const math_f::agaa_DepthPlane plane = planeOf(t, centre);
        const float depth = math_f::agaa_depthAt(plane, {0, 0});
        EXPECT_GE(depth, least - 1e-7f);
        EXPECT_LE(depth, greatest + 1e-7f);
        if (edgeOn) {
            outside += !(naive >= least - 1e-3f && naive <= greatest + 1e-3f);
        } else if (contains(t.at, glm::dvec2(centre))) {
            const double exact = trueDepth(t, glm::dvec2(centre));
            printed = std::max(printed, std::abs(double(naive) - exact));
            ours = std::max(ours, std::abs(double(depth) - exact));
        }
    }
    std::printf("[ measured ] error of the printed equation %.3g, of the plane from the centre %.3g; outside the "
                "triangle's depths %zu of 10000\n",
                printed, ours, outside);
    EXPECT_GT(printed, 10 * ours);
    EXPECT_GT(outside, 1000u);
    EXPECT_LT(ours, 2e-7);
}

// Hard cases 45, 46 and 48: slopes stay finite, and depths stay those of the triangle.
TEST(DepthPlane, EdgeOnTrianglesKeepTheirDepths) {
    Random random(46);
    float steepest = 0;
    for (int i = 0; i < 100000; ++i) {
        const double thickness = i % 10 == 0 ? 0 : random.decades(1e-12, 1), turn = random.range(0, 6.3);
        const glm::dvec2 at(random.range(0, 4096), random.range(0, 4096)), d(std::cos(turn), std::sin(turn));
        const double length = random.decades(0.1, 1000);
        std::array<glm::dvec3, 3> v;
        for (glm::dvec3& p : v) {
            const double along = length * random.range(-1, 1), aside = thickness * random.range(-1, 1);
            p = {at.x + d.x * along - d.y * aside, at.y + d.y * along + d.x * aside, random.decades(0.2, 100)};
        }
        const Triangle t = place(v, i % 2 != 0);
        float least = 1, greatest = 0;
        for (int k = 0; k < 3; ++k) {
            const float depth = t.z[k] / t.at[static_cast<std::size_t>(k)].z;
            least = std::min(least, depth);
            greatest = std::max(greatest, depth);
        }
        const math_f::agaa_DepthPlane plane = planeOf(t, glm::vec2(glm::floor(at) + 0.5));
        EXPECT_TRUE(std::isfinite(plane.depth) && std::isfinite(plane.slope.x) && std::isfinite(plane.slope.y));
        steepest = std::max(steepest, (std::abs(plane.slope.x) + std::abs(plane.slope.y)) / (greatest - least));
        EXPECT_GE(plane.range.x, least);
        EXPECT_LE(plane.range.y, greatest);
        for (unsigned s = 0; s < 64; s += 7) {
            const float depth = math_f::agaa_depthAt(plane, math_f::agaa_coveragePosition(s, 64));
            EXPECT_GE(depth, least);
            EXPECT_LE(depth, greatest);
        }
    }
    EXPECT_LE(steepest, math_f::agaa_steepestSlope() * 1.00001f);
}

// Hard case 46: a wall seen at a grazing angle reaches neither the fence in front of it nor what is far behind it.
TEST(DepthPlane, AGrazingWallOverlapsOnlyItsOwnDepths) {
    const glm::vec2 centre(960.5f, 540.5f);
    const auto flat = [&](double w) {
        return planeOf(place({glm::dvec3(900, 500, w), glm::dvec3(1100, 500, w), glm::dvec3(960, 700, w)}, false),
                       centre);
    };
    // 0.002 pixels wide, between w = 20 and 30.
    const auto wall = planeOf(
        place({glm::dvec3(960.5, 400, 20), glm::dvec3(960.5, 700, 20), glm::dvec3(960.502, 540, 30)}, false), centre);
    EXPECT_FALSE(math_f::agaa_depthsOverlap(wall, flat(15), 1e-6f));
    EXPECT_TRUE(math_f::agaa_depthsOverlap(wall, flat(25), 1e-6f));
    EXPECT_FALSE(math_f::agaa_depthsOverlap(wall, flat(40), 1e-6f));
    EXPECT_TRUE(math_f::agaa_depthsOverlap(flat(15), flat(15), 1e-6f));
    EXPECT_FALSE(math_f::agaa_depthsOverlap(flat(15), flat(15.1), 1e-6f));
}

// Hard case 50.
TEST(DepthPlane, TrianglesThroughTheEyePlane) {
    Random random(50);
    Worst worst("depth, vertices behind the eye", 1e-5);
    std::size_t covered = 0;
    for (int i = 0; i < 100000; ++i) {
        const glm::vec2 centre(float(random.below(1920)) + 0.5f, float(random.below(1080)) + 0.5f);
        Triangle t;
        for (std::size_t k = 0; k < 3; ++k) {
            const double w = random.range(-1, 4);
            t.at[k] = glm::vec3(glm::dvec3(double(centre.x) * w + random.range(-1, 1) * 300,
                                           double(centre.y) * w + random.range(-1, 1) * 300, w));
            t.z[static_cast<int>(k)] = clipZ(double(t.at[k].z), i % 2 != 0);
        }
        const math_f::agaa_DepthPlane plane = planeOf(t, centre);
        EXPECT_TRUE(plane.range.x >= 0 && plane.range.x <= plane.range.y && plane.range.y <= 1);
        for (unsigned s = 0; s < 64; s += 9) {
            const glm::dvec2 offset = math_d::agaa_coveragePosition(s, 64);
            if (!contains(t.at, glm::dvec2(centre) + offset))
                continue;
            const double depth = trueDepth(t, glm::dvec2(centre) + offset);
            if (depth < 0 || depth > 1) // before the near plane
                continue;
            worst.absolute(double(math_f::agaa_depthAt(plane, glm::vec2(offset))), depth);
            ++covered;
        }
    }
    EXPECT_GT(covered, 20000u);
}

TEST(DepthPlane, ExtremeInputStaysFinite) {
    std::vector<float> values = extremeFloats();
    values.insert(values.end(), {infinityF(), nanF()});
    Random random(52);
    const auto pick = [&] { return values[random.below(unsigned(values.size()))]; };
    for (int i = 0; i < 200000; ++i) {
        const Triangle t = {{glm::vec3(pick(), pick(), pick()), {pick(), pick(), pick()}, {pick(), pick(), pick()}},
                            {pick(), pick(), pick()}};
        const math_f::agaa_DepthPlane p = planeOf(t, {0.5f, 8191.5f});
        EXPECT_TRUE(std::isfinite(p.depth) && std::isfinite(p.slope.x) && std::isfinite(p.slope.y)) << i;
        EXPECT_TRUE(p.range.x >= 0 && p.range.x <= p.range.y && p.range.y <= 1) << i;
    }
}

} // namespace
