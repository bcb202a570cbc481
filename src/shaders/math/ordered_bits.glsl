// Maps floats to integers of the same order.
#ifndef AGAA_MATH_ORDERED_BITS_GLSL
#define AGAA_MATH_ORDERED_BITS_GLSL
#include "real.glsl"

uint agaa_orderedBits(real x) {
    const uint bits = floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

real agaa_fromOrderedBits(uint bits) {
    return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7FFFFFFFu : ~bits);
}

#endif
