// The shader mathematics of src/shaders/math, compiled as C++ twice: math_f in float, as the GPU
// computes it, and math_d in double, the reference.
//
// The functions of the clustering work on global arrays; in C++ they are members of the struct
// Clustering, so that any number of pixels can be processed side by side. The words of fragments are members of
// FragmentLists.
#ifndef AGAA_TESTS_SHADER_MATH_H
#define AGAA_TESTS_SHADER_MATH_H

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/glm.hpp>
#include <glm/integer.hpp>

#include "../../src/shaders/tables/layouts.inc"

#define AGAA_MATH_CPP
#define AGAA_MAX_SAMPLES 32
#define OUT(T) T&
#define INOUT(T) T&
#define PRECISE

// The functions are internal to each translation unit, which need not use all of them.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

#define AGAA_MATH_USINGS                                                                                               \
    using glm::uint;                                                                                                   \
    using glm::uvec2;                                                                                                  \
    using glm::uvec3;                                                                                                  \
    using glm::uvec4;                                                                                                  \
    using glm::bitCount;                                                                                               \
    using glm::abs;                                                                                                    \
    using glm::ceil;                                                                                                   \
    using glm::clamp;                                                                                                  \
    using glm::cos;                                                                                                    \
    using glm::cross;                                                                                                  \
    using glm::dot;                                                                                                    \
    using glm::exp;                                                                                                    \
    using glm::exp2;                                                                                                   \
    using glm::findLSB;                                                                                                \
    using glm::findMSB;                                                                                                \
    using glm::floor;                                                                                                  \
    using glm::log;                                                                                                    \
    using glm::log2;                                                                                                   \
    using glm::max;                                                                                                    \
    using glm::min;                                                                                                    \
    using glm::mix;                                                                                                    \
    using glm::normalize;                                                                                              \
    using glm::pow;                                                                                                    \
    using glm::sin;                                                                                                    \
    using glm::sqrt;

namespace math_f {
AGAA_MATH_USINGS
using real = float;
using rvec2 = glm::vec2;
using rvec3 = glm::vec3;
using rvec4 = glm::vec4;
namespace {
uint floatBitsToUint(real x) { return std::bit_cast<std::uint32_t>(x); }
real uintBitsToFloat(uint bits) { return std::bit_cast<float>(bits); }
bool agaa_exponentIsAllOnes(real x) { return (floatBitsToUint(x) & 0x7F800000u) == 0x7F800000u; }
#include "shader_math_files.inl"
} // namespace
} // namespace math_f

namespace math_d {
AGAA_MATH_USINGS
using real = double;
using rvec2 = glm::dvec2;
using rvec3 = glm::dvec3;
using rvec4 = glm::dvec4;
namespace {
// Words hold floats in both precisions.
uint floatBitsToUint(real x) { return std::bit_cast<std::uint32_t>(float(x)); }
real uintBitsToFloat(uint bits) { return real(std::bit_cast<float>(bits)); }
bool agaa_exponentIsAllOnes(real x) {
    return (std::bit_cast<std::uint64_t>(x) & 0x7FF0000000000000u) == 0x7FF0000000000000u;
}
#include "shader_math_files.inl"
} // namespace
} // namespace math_d

#undef AGAA_MATH_USINGS
#undef INOUT
#undef PRECISE
#undef OUT
#pragma GCC diagnostic pop

#endif
