// What the tests of the shader mathematics share: repeatable random values, error measures and a
// bound that prints what was measured against it.
#ifndef AGAA_TESTS_MATH_TEST_SUPPORT_H
#define AGAA_TESTS_MATH_TEST_SUPPORT_H

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include "shader_math.h"

namespace test_math {

// Rounds a number to one of 16 bits.
inline float asHalf(float x) { return glm::unpackHalf1x16(glm::packHalf1x16(x)); }

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    // Not std::uniform_real_distribution, whose values differ between standard libraries.
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double range(double lo, double hi) { return lo + (hi - lo) * unit(); }
    float rangeF(double lo, double hi) { return static_cast<float>(range(lo, hi)); }
    // Uniform in the logarithm, for quantities that span decades.
    double decades(double lo, double hi) { return std::exp(range(std::log(lo), std::log(hi))); }
    unsigned below(unsigned n) { return static_cast<unsigned>(engine_() % n); }

    glm::dvec3 direction() {
        const double z = range(-1.0, 1.0);
        const double phi = range(0.0, 6.283185307179586);
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    }
    // Uniform over the cap of directions with z >= minZ.
    glm::dvec3 hemisphere(double minZ = 0.0) {
        glm::dvec3 d = direction();
        d.z = range(minZ, 1.0);
        const double r = std::sqrt(1.0 - d.z * d.z);
        const double phi = range(0.0, 6.283185307179586);
        return {r * std::cos(phi), r * std::sin(phi), d.z};
    }

private:
    std::mt19937_64 engine_;
};

// Keeps the largest error seen; on destruction prints it and fails the test if it exceeds the
// bound.
class Worst {
public:
    Worst(std::string what, double bound) : what_(std::move(what)), bound_(bound) {}
    Worst(const Worst&) = delete;
    Worst& operator=(const Worst&) = delete;
    ~Worst() {
        std::printf("[ measured ] %-58s %.3g (bound %.3g)\n", what_.c_str(), max_, bound_);
        EXPECT_LE(max_, bound_) << what_;
    }

    void absolute(double value, double reference) { add(std::abs(value - reference)); }
    // Relative to the reference, or to `floor` where the reference is smaller than that.
    void relative(double value, double reference, double floor = 1e-300) {
        add(std::abs(value - reference) / std::max(std::abs(reference), floor));
    }
    void add(double error) {
        // A NaN must not vanish in a comparison.
        if (std::isnan(error)) {
            error = std::numeric_limits<double>::infinity();
        }
        max_ = std::max(max_, error);
    }
    double value() const { return max_; }

private:
    std::string what_;
    double bound_;
    double max_ = 0.0;
};

inline double degreesBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

inline bool allFinite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Values at which formulas break: both zeros, denormals, around 1, the largest half, the ends.
inline std::vector<float> extremeFloats() {
    using L = std::numeric_limits<float>;
    std::vector<float> v = {0.0f,    L::denorm_min(),
                            1e-40f,  L::min(),
                            1e-20f,  1e-7f,
                            0.5f,    std::nextafter(1.0f, 0.0f),
                            1.0f,    std::nextafter(1.0f, 2.0f),
                            1.1f,    65504.0f,
                            1e12f,   1e20f,
                            L::max()};
    const std::size_t positive = v.size();
    for (std::size_t i = 0; i < positive; ++i) {
        v.push_back(-v[i]);
    }
    return v;
}

inline float infinityF() { return std::numeric_limits<float>::infinity(); }
inline float nanF() { return std::numeric_limits<float>::quiet_NaN(); }

} // namespace test_math

#endif
