// The number type of the shared mathematics and the spelling of what GLSL and C++ say differently.
// Source: AGAA SDK design, section 3 ("math is written once"); hard cases 37 and 56.
//
// In C++ the including file (tests/math/shader_math.h) defines AGAA_MATH_CPP and supplies real,
// rvec2..4, uvec2..4, OUT, INOUT, PRECISE and agaa_exponentIsAllOnes for its precision. Literals are always
// written inside real(): a bare literal is a double in C++ and would hide the error of the GPU.
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

// Infinities and NaNs are the values whose exponent bits are all ones. Bits cannot be folded away
// by a compiler that assumes there are no NaNs, a comparison x == x can.
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

// 1/x with the sign of x kept and the magnitude of x held above 1e-25, so that the result is finite
// even if x is 0 or denormal.
real agaa_guardedReciprocal(real x) {
    const real magnitude = max(abs(x), real(1e-25));
    return x < real(0.0) ? real(-1.0) / magnitude : real(1.0) / magnitude;
}

#endif
