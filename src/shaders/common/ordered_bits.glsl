// Maps floats to integers of the same order.
#ifndef AGAA_ORDERED_BITS_GLSL
#define AGAA_ORDERED_BITS_GLSL

uint agaa_orderedBits(float x) {
    uint bits = floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

float agaa_fromOrderedBits(uint bits) {
    return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7FFFFFFFu : ~bits);
}
#endif
