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

} // namespace test_math

#endif
