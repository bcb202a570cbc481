// Hard cases 45, 46 and 52 of docs/numerics.md: depths of triangles in a pixel.
#include <algorithm>

#include <glm/gtc/packing.hpp>

#include "coverage_oracle.h"
#include "hard_case_figures.h"

using namespace test_math;

namespace {

struct DepthTriangle {
    Vertices at;
    glm::vec3 z;
};

// A triangle of points in pixels with depths in [0, 1], and the w of a projection.
DepthTriangle placed(const std::array<glm::dvec3, 3>& points) {
    DepthTriangle t;
    for (std::size_t k = 0; k < 3; ++k) {
        const double w = 0.1 / (1.0001 - points[k].z);
        t.at[k] = vertex(points[k].x, points[k].y, w);
        t.z[int(k)] = float(points[k].z * double(t.at[k].z));
    }
    return t;
}

double trueDepth(const DepthTriangle& t, const glm::dvec2& point) {
    const glm::dvec3 a = atPoint(t.at[0], point), b = atPoint(t.at[1], point), c = atPoint(t.at[2], point);
    const glm::dvec3 e(glm::cross(b, c).z, glm::cross(c, a).z, glm::cross(a, b).z);
    return glm::dot(e, glm::dvec3(t.z)) / glm::dot(e, glm::dvec3(a.z, b.z, c.z));
}

math_f::agaa_DepthPlane planeOf(const DepthTriangle& t, const glm::vec2& centre) {
    return math_f::agaa_depthPlane(t.at[0], t.at[1], t.at[2], t.z, centre);
}

// The plane through the vertices in absolute pixels, as the paper prints it.
struct PrintedPlane {
    glm::vec3 n;
    float w;
    float at(const glm::vec2& p) const { return -(n.x * p.x + n.y * p.y + w) / n.z; }
};

PrintedPlane printedPlane(const DepthTriangle& t) {
    const auto divided = [&](int k) {
        return glm::vec3(t.at[std::size_t(k)].x, t.at[std::size_t(k)].y, t.z[k]) / t.at[std::size_t(k)].z;
    };
    const glm::vec3 p = divided(0), n = glm::cross(divided(1) - p, divided(2) - p);
    return {n, -glm::dot(n, p)};
}

glm::dvec2 rangeOf(const DepthTriangle& t) {
    const glm::dvec3 d = glm::dvec3(t.z) / glm::dvec3(t.at[0].z, t.at[1].z, t.at[2].z);
    return {std::min({d.x, d.y, d.z}), std::max({d.x, d.y, d.z})};
}

} // namespace

TEST(HardCase45_DepthOfEdgeOnTriangles, PlanesFromThePixelsCentre) {
    Random random(645);
    HardCaseFigures figures(45, "error of a sample's depth, or distance from the depths of the triangle", 1e-6);
    for (int i = 0; i < 100000; ++i) {
        const glm::vec2 centre(float(random.below(16384)) + 0.5f, float(random.below(16384)) + 0.5f);
        const bool isEdgeOn = i % 2 != 0;
        std::array<glm::dvec3, 3> points;
        const double angle = random.range(0, 6.283185307179586), thickness = random.decades(1e-4, 1e-2);
        for (glm::dvec3& p : points) {
            const double u = random.range(-20, 20), v = random.range(-20, 20) * (isEdgeOn ? thickness : 1.0);
            p = {double(centre.x) + std::cos(angle) * u - std::sin(angle) * v,
                 double(centre.y) + std::sin(angle) * u + std::cos(angle) * v, random.range(0.5, 0.6)};
        }
        const DepthTriangle t = placed(points);
        const PrintedPlane printed = printedPlane(t);
        const math_f::agaa_DepthPlane plane = planeOf(t, centre);
        const glm::dvec2 range = rangeOf(t);
        for (unsigned s = 0; s < 64; s += 21) {
            const glm::dvec2 offset = math_d::agaa_coveragePosition(s, 64);
            const double naive = double(printed.at(centre + glm::vec2(offset)));
            const double ours = double(math_f::agaa_depthAt(plane, glm::vec2(offset)));
            if (!isEdgeOn && contains(t.at, glm::dvec2(centre) + offset)) {
                const double depth = trueDepth(t, glm::dvec2(centre) + offset);
                figures.naive(std::abs(naive - depth));
                // The slope carries the rounding of the vertices: 2e-6 pixels.
                const double slope = double(std::abs(plane.slope.x) + std::abs(plane.slope.y));
                figures.ours(std::max(0.0, std::abs(ours - depth) - 2e-6 * slope), s == 0);
            }
            const auto outside = [&](double depth) {
                return std::isnan(depth) ? depth : std::max({0.0, range.x - depth, depth - range.y});
            };
            if (isEdgeOn) {
                figures.naive(outside(naive));
                figures.ours(outside(ours), s == 0);
            } else {
                figures.ours(outside(ours), s == 0);
            }
        }
    }
}

TEST(HardCase46_InfiniteDepthSlopes, WallsDoNotOverlapTheFence) {
    Random random(646);
    HardCaseFigures figures(46, "share of pixels in which a wall seen edge-on overlaps the fence before it", 0.0);
    Share naive, ours;
    for (int i = 0; i < 100000; ++i) {
        const glm::vec2 centre(float(random.below(1920)) + 0.5f, float(random.below(1080)) + 0.5f);
        // A wall at an angle of 89.99 degrees is 1/6000 as wide as deep; it crosses the pixel.
        const double width = random.decades(1e-5, 1e-2), x = double(centre.x) + random.range(-0.4, 0.4);
        const DepthTriangle wall =
            placed({glm::dvec3(x, double(centre.y) - 30, 0.5), glm::dvec3(x, double(centre.y) + 30, 0.5),
                    glm::dvec3(x + width, double(centre.y), 0.9)});
        const DepthTriangle fence = placed({glm::dvec3(double(centre.x) - 9, double(centre.y) - 9, 0.4),
                                            glm::dvec3(double(centre.x) + 9, double(centre.y) - 9, 0.4),
                                            glm::dvec3(double(centre.x), double(centre.y) + 9, 0.41)});
        // The box of a plane with slopes as they come, stored in half floats.
        const auto box = [&](const DepthTriangle& t) {
            const PrintedPlane p = printedPlane(t);
            const float depth = asHalf(p.at(centre)),
                        reach = 0.5f * (std::abs(asHalf(p.n.x / p.n.z)) + std::abs(asHalf(p.n.y / p.n.z)));
            return glm::vec2(depth - reach, depth + reach);
        };
        const glm::vec2 a = box(wall), b = box(fence);
        naive.add(!(a.x > b.y || b.x > a.y));
        ours.add(math_f::agaa_depthsOverlap(planeOf(wall, centre), planeOf(fence, centre), 1e-6f));
    }
    figures.naive(naive.value());
    figures.ours(ours.value(), ours.inputs());
}

TEST(HardCase52_PrepassOfFewerSamples, NothingLeaksAtEdges) {
    Random random(652);
    HardCaseFigures figures(52, "samples of a near surface that show the far one, of 64", 0.0);
    // The standard locations of eight samples, in sixteenths.
    const int prepass[8][2] = {{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}};
    for (int i = 0; i < 100000; ++i) {
        const glm::vec2 centre(float(random.below(1920)) + 0.5f, float(random.below(1080)) + 0.5f);
        // A near strip that crosses the pixel, whose edges pass between the samples of the prepass.
        const double angle = random.range(0, 6.283185307179586), width = random.decades(0.1, 2);
        const glm::dvec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
        const glm::dvec2 p = glm::dvec2(centre) + across * random.range(-0.5, 0.5);
        const auto at = [&](double u, double v) {
            const glm::dvec2 q = p + along * u + across * v;
            return vertex(q.x, q.y);
        };
        const Vertices halves[] = {{at(-20, 0), at(20, 0), at(20, width)}, {at(-20, 0), at(20, width), at(-20, width)}};
        const glm::uvec4 near = mask(halves[0], centre, 64) | mask(halves[1], centre, 64);
        // The depths are planes of the pixel: the near one in front of the far one everywhere.
        const auto plane = [&](float depth) {
            const glm::vec2 slope(random.rangeF(-0.05, 0.05), random.rangeF(-0.05, 0.05));
            const float reach = 0.5f * (std::abs(slope.x) + std::abs(slope.y));
            return math_f::agaa_DepthPlane{depth, slope, {depth - reach, depth + reach}};
        };
        const math_f::agaa_DepthPlane nearPlane = plane(0.4f), farPlane = plane(0.6f);
        const glm::uvec4 hidden = math_f::agaa_samplesBehind(farPlane, nearPlane, near, false, 64);
        unsigned leaked = 0;
        for (unsigned s = 0; s < 64; ++s) {
            if (!math_f::agaa_isCovered(near, s))
                continue;
            // The sample takes the depth of the nearest sample of the prepass.
            const glm::vec2 position = math_f::agaa_coveragePosition(s, 64);
            glm::dvec2 nearest(0);
            float least = 9;
            for (const auto& q : prepass) {
                const glm::vec2 d = glm::vec2(float(q[0]), float(q[1])) / 16.0f - 0.5f;
                if (glm::length(d - position) < least) {
                    least = glm::length(d - position);
                    nearest = glm::dvec2(d);
                }
            }
            const glm::dvec2 point = glm::dvec2(centre) + nearest;
            leaked += !contains(halves[0], point) && !contains(halves[1], point);
        }
        figures.add(leaked, math_f::agaa_coverageCount(near & ~hidden));
    }
}
