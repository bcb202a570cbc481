// Sums over the samples of a pixel in integers, so that the order of the terms does not matter.
#ifndef AGAA_MATH_PIXEL_SUMS_GLSL
#define AGAA_MATH_PIXEL_SUMS_GLSL
#include "real.glsl"

// Values are in [-1, 1] and a pixel has up to 128 samples, so that sums are in [-2^30, 2^30].
#define AGAA_SUM_STEPS real(8388608.0)
// Depths are in [0, 1], so that their sums are at most 2^31.
#define AGAA_DEPTH_SUM_STEPS real(16777216.0)

// Returns a term. sum: over samples.
uint agaa_sumTerm(real sum) { return uint(int(floor(sum * AGAA_SUM_STEPS + real(0.5)))); }
uint agaa_depthSumTerm(real sum) { return uint(sum * AGAA_DEPTH_SUM_STEPS + real(0.5)); }

// Return the means of `samples` samples, or 0 without samples.
real agaa_meanOfTerms(uint terms, uint samples) {
    return samples == 0u ? real(0.0) : real(int(terms)) / (AGAA_SUM_STEPS * real(samples));
}
real agaa_meanOfDepthTerms(uint terms, uint samples) {
    return samples == 0u ? real(0.0) : real(terms) / (AGAA_DEPTH_SUM_STEPS * real(samples));
}

#endif
