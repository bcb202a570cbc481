// What the tests of coverage share: coverage computed another way, in double, with a sign test per sample against the
// edges of the triangle as given.
#ifndef AGAA_TESTS_MATH_COVERAGE_ORACLE_H
#define AGAA_TESTS_MATH_COVERAGE_ORACLE_H

#include <algorithm>
#include <array>
#include <vector>

#include "test_support.h"

namespace test_math {

// A vertex (x w, y w, w) in pixels.
using Vertices = std::array<glm::vec3, 3>;

inline glm::vec3 vertex(double x, double y, double w = 1) { return glm::vec3(glm::dvec3(x * w, y * w, w)); }

inline double det(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a, glm::cross(b, c));
}

inline glm::dvec3 atPoint(const glm::vec3& v, const glm::dvec2& point) {
    const glm::dvec3 d(v);
    return {d.x - point.x * d.z, d.y - point.y * d.z, d.z};
}

// Whether the part of the triangle in front of the eye contains the point. Homogeneous: no vertex is divided.
inline bool contains(const Vertices& t, const glm::dvec2& point) {
    const glm::dvec3 a = atPoint(t[0], point), b = atPoint(t[1], point), c = atPoint(t[2], point);
    const auto cross = [](const glm::dvec3& p, const glm::dvec3& q) { return p.x * q.y - p.y * q.x; };
    const double area = det(a, b, c), sign = area < 0 ? -1 : 1;
    return area != 0 && sign * cross(b, c) > 0 && sign * cross(c, a) > 0 && sign * cross(a, b) > 0;
}

inline glm::uvec4 oracleMask(const Vertices& t, const glm::dvec2& centre, unsigned samples) {
    glm::uvec4 mask(0);
    for (unsigned i = 0; i < samples; ++i)
        if (contains(t, centre + math_d::agaa_coveragePosition(i, samples)))
            mask[static_cast<int>(i >> 5)] |= 1u << (i & 31);
    return mask;
}

inline glm::uvec4 mask(const Vertices& t, const glm::vec2& centre, unsigned samples) {
    return math_f::agaa_triangleCoverage(t[0], t[1], t[2], centre, samples);
}

inline unsigned differingBits(const glm::uvec4& a, const glm::uvec4& b) { return math_f::agaa_coverageCount(a ^ b); }

using Polygon = std::vector<glm::dvec2>;

// The part of a convex polygon where a x + b y + c >= 0.
inline Polygon clipped(const Polygon& in, const glm::dvec3& line) {
    Polygon out;
    for (std::size_t i = 0; i < in.size(); ++i) {
        const glm::dvec2 p = in[i], q = in[(i + 1) % in.size()];
        const double e = line.x * p.x + line.y * p.y + line.z, f = line.x * q.x + line.y * q.y + line.z;
        if (e >= 0)
            out.push_back(p);
        if ((e >= 0) != (f >= 0))
            out.push_back(p + (q - p) * (e / (e - f)));
    }
    return out;
}

inline double areaOf(const Polygon& p) {
    double twice = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const glm::dvec2 a = p[i], b = p[(i + 1) % p.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return twice / 2;
}

// Vertices of a triangle in clip space.
using Clip = std::array<glm::vec4, 3>;

// The vertex at a position in ndc. The near plane, as agaa_triangleHull() has it, is at w = 0.1.
inline glm::vec4 clipVertex(const glm::dvec2& ndc, double w, const glm::dvec2& nearPlane) {
    const double beyond = (w - 0.1) * 1.0001;
    const double z = nearPlane.x < 0 ? w - beyond : nearPlane.y > 0 ? 2 * beyond - w : beyond;
    return glm::vec4(glm::dvec4(ndc.x * w, ndc.y * w, z, w));
}

// The part of a triangle in front of the near plane, in pixels from the image's middle, by a clipper in double.
inline Polygon projected(const Clip& t, const glm::dvec2& nearPlane, const glm::dvec2& halfSize) {
    Polygon out;
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec4 a(t[k]), b(t[(k + 1) % 3]);
        const double e = nearPlane.x * a.z + nearPlane.y * a.w, f = nearPlane.x * b.z + nearPlane.y * b.w;
        const auto add = [&](const glm::dvec4& v) { out.push_back(glm::dvec2(v) / v.w * halfSize); };
        if (e >= 0)
            add(a);
        if ((e >= 0) != (f >= 0))
            add(a + (b - a) * (e / (e - f)));
    }
    if (areaOf(out) < 0)
        std::reverse(out.begin(), out.end());
    return out;
}

// Returns true if a polygon, which may be a line, touches a square around a point.
inline bool touches(Polygon p, const glm::dvec2& centre, double halfWidth = 0.5) {
    for (const glm::dvec2 n : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)})
        p = clipped(p, {n.x, n.y, halfWidth - glm::dot(n, centre)});
    return !p.empty();
}

} // namespace test_math

#endif
