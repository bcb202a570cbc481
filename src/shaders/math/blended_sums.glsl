// Sums of an aggregate's attributes in UNORM attachments, by additive blending. A fragment with k of n samples adds k/n
// of its value, as a whole code: sums are exact, and do not depend on the order of the fragments. An aggregate of
// `count` samples holds count/n of its mean. m fragments in it round the mean by at most m/2 * n/count codes of the
// attachment.
// Source: AGAA (Crassin et al., TVCG 2016) sections 4.2.1 and 4.3.
#ifndef AGAA_MATH_BLENDED_SUMS_GLSL
#define AGAA_MATH_BLENDED_SUMS_GLSL
#include "real.glsl"
#include "sanitise.glsl"
#include "encoding.glsl"

// Returns the code that stands for 0 in the sum of `count` signed values. Attachments have at least 8 bits and n is at
// most 32, so that n divides the centre.
uint agaa_blendCentre(uint count, uint n, uint bits) {
    return (1u << (clamp(bits, 8u, 24u) - 1u)) * count / max(n, 1u);
}

// Returns the code that a fragment with `count` of n samples adds for a value in [0, 1]. Non-finite values count as 0.
uint agaa_blendCode(real v, uint count, uint n, uint bits) {
    uint code = 0u;
    if (agaa_isFinite(v)) {
        const real top = real(agaa_maxCode(bits)) * real(count) / real(max(n, 1u));
        code = uint(agaa_saturate(v) * top + real(0.5));
    }
    return code;
}

// Returns the same for a value in [-1, 1].
uint agaa_signedBlendCode(real v, uint count, uint n, uint bits) {
    const uint centre = agaa_blendCentre(count, n, bits);
    real above = real(0.0);
    if (agaa_isFinite(v)) {
        const real span = real(agaa_blendCentre(n, n, bits) - 1u) * real(count) / real(max(n, 1u));
        above = floor(clamp(v, real(-1.0), real(1.0)) * span + real(0.5));
    }
    // The sum is not negative before the conversion: `above` is at least -centre.
    return uint(above + real(centre));
}

// Returns the value to write to a channel of an attachment.
real agaa_blendedValue(real v, uint count, uint n, uint bits, bool isSigned) {
    const uint code = isSigned ? agaa_signedBlendCode(v, count, n, bits) : agaa_blendCode(v, count, n, bits);
    return agaa_unormOfCode(rvec2(real(code)), bits).x;
}

// Returns the value to write to the 8-bit channel of samples 8 * part to 8 * part + 7. Each sample is added once, so
// that the sum of masks is their union.
real agaa_blendedMask(uint mask, uint part) {
    return agaa_unormOfCode(rvec2(real((mask >> (8u * part)) & 0xFFu)), 8u).x;
}

// Returns the code of a texel's channel.
uint agaa_blendedCode(real texel, uint bits) {
    return uint(agaa_saturate(texel) * real(agaa_maxCode(bits)) + real(0.5));
}

// Returns the mean, in [0, 1], of the `count` samples in a sum; 0 without samples.
real agaa_meanOfBlended(uint sum, uint count, uint n, uint bits) {
    real mean = real(0.0);
    if (count > 0u) {
        mean = min(real(sum) * real(n) / (real(count) * real(agaa_maxCode(bits))), real(1.0));
    }
    return mean;
}

// Returns the same of signed values, in [-1, 1]. Values of 0 have a mean of exactly 0.
real agaa_signedMeanOfBlended(uint sum, uint count, uint n, uint bits) {
    real mean = real(0.0);
    if (count > 0u) {
        const int above = int(sum) - int(agaa_blendCentre(count, n, bits));
        const real span = real(agaa_blendCentre(n, n, bits) - 1u);
        mean = clamp(real(above) * real(n) / (real(count) * span), real(-1.0), real(1.0));
    }
    return mean;
}

#endif
