// Limits of number formats.
#ifndef AGAA_MATH_LIMITS_GLSL
#define AGAA_MATH_LIMITS_GLSL
#include "real.glsl"

#define AGAA_MAX_HALF real(65504.0) // the largest finite value of 16 bits

#endif
