// Compiled with -ffast-math, which lets the compiler assume that there are no NaNs. Types and
// functions are local, not GLM's: inline functions of a header compiled here could otherwise
// replace their strict versions in the whole executable.
#include "guards_fast_math.h"

#include <bit>
#include <cstdint>

namespace {

using uint = std::uint32_t;
using real = float;
struct rvec3 {
    float x, y, z;
    rvec3(float a, float b, float c) : x(a), y(b), z(c) {}
};
inline float abs(float x) { return x < 0.0f ? -x : x; }
inline float max(float a, float b) { return a < b ? b : a; }
inline float clamp(float x, float lo, float hi) { return x < lo ? lo : (x > hi ? hi : x); }
inline bool agaa_exponentIsAllOnes(float x) { return (std::bit_cast<std::uint32_t>(x) & 0x7F800000u) == 0x7F800000u; }

#define AGAA_MATH_CPP
#define OUT(T) T&
#define INOUT(T) T&
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "../../src/shaders/math/sanitise.glsl"
#pragma GCC diagnostic pop

} // namespace

bool fastMathIsFinite(float x) { return agaa_isFinite(x); }

float fastMathSanitise(float x, float lo, float hi, unsigned& bad) { return agaa_sanitise(x, lo, hi, bad); }

bool fastMathComparesEqualToItself(float x) { return x == x; }
