// Limits of number formats.
#ifndef AGAA_MATH_LIMITS_GLSL
#define AGAA_MATH_LIMITS_GLSL
#include "real.glsl"

#define AGAA_MAX_FLOAT real(3.402823e38)
#define AGAA_MAX_HALF real(65504.0) // the largest finite value of 16 bits
#define AGAA_MIN_NORMAL real(1.17549435e-38) // the smallest float that is not denormal

#endif
