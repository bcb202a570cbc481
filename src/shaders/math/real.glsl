// The number type of the shared mathematics, and macros for syntax that differs between GLSL and C++.
// Source: docs/numerics.md, cases 37 and 56.
//
// In C++ the includer (tests/math/shader_math.h) defines AGAA_MATH_CPP and declares real, rvec2 to rvec4, uvec2 to
// uvec4, OUT, INOUT, PRECISE and agaa_exponentIsAllOnes() for its precision. Literals are always inside real(), because
// a plain literal is a double in C++ and would hide the error of the GPU.
#ifndef AGAA_MATH_REAL_GLSL
#define AGAA_MATH_REAL_GLSL

#ifndef AGAA_MATH_CPP
#define real float
#define rvec2 vec2
#define rvec3 vec3
#define rvec4 vec4
#define OUT(T) out T
#define INOUT(T) inout T
#define PRECISE precise // neither contracted nor reordered

// Returns whether x is infinite or NaN, whose exponent bits are all ones. A compiler that assumes no NaNs may remove a
// comparison x == x, but not a test of bits.
bool agaa_exponentIsAllOnes(real x) {
    return (floatBitsToUint(x) & 0x7F800000u) == 0x7F800000u;
}
#endif

real agaa_pi() {
    return real(3.14159265358979323846);
}

real agaa_saturate(real x) {
    return clamp(x, real(0.0), real(1.0));
}

real agaa_sq(real x) {
    return x * x;
}

// Returns the power of two by which to multiply numbers up to `largest` before a division by a number of that size.
// GPUs compute x / y as x * (1 / y), which is 0 above 2^126, where 1 / y is denormal; Vulkan leaves this result open.
real agaa_divisionScale(real largest) {
    return abs(largest) > real(1e37) ? real(1.52587890625e-5) : real(1.0); // 2^-16
}

// Returns x / y for each finite y that is not denormal.
real agaa_quotient(real x, real y) {
    const real scale = agaa_divisionScale(y);
    return x * scale / (y * scale);
}

rvec3 agaa_quotient3(rvec3 v, real y) {
    return rvec3(agaa_quotient(v.x, y), agaa_quotient(v.y, y), agaa_quotient(v.z, y));
}

// Returns 1/x with the magnitude of x at least 1e-25, so that the result is finite if x is 0 or denormal.
// Above 2^126 it is denormal, which GPUs make 0.
real agaa_guardedReciprocal(real x) {
    const real magnitude = max(abs(x), real(1e-25));
    return x < real(0.0) ? real(-1.0) / magnitude : real(1.0) / magnitude;
}

#endif
