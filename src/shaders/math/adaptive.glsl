// How many samples of a pixel are shaded, and which of them.
// Sources: Hollaender et al. 2013, "Adaptive Supersampling for Deferred Anti-Aliasing", section 3.1; hard cases 12, 13, 15
// and 43.
#ifndef AGAA_MATH_ADAPTIVE_GLSL
#define AGAA_MATH_ADAPTIVE_GLSL
#include "real.glsl"

// k_s: c times the range of luminances, 0 where it does not exceed the thresholds.
real agaa_shadingCount(real lowest, real highest, real relative, real absolute, real c) {

    const real range = highest - lowest;
    return range < max(absolute, highest * relative) ? real(0.0) : c * range;
}

// The least whole number of samples that is not below k, in [least, most]; k may be infinite or NaN.
uint agaa_wholeCount(real k, uint least, uint most) {
    const real bounded = k < real(most) ? ceil(max(k, real(least))) : real(most); // NaN: most
    return uint(bounded);
}

// The difference of two unit normals in shares of the angle whose cosine is given: |a - b|^2 / 2 is 1 - a.b without
// cancellation. A normal that was flipped differs.
real agaa_normalStep(rvec3 a, rvec3 b, real cosine) {
    const rvec3 d = a - b;
    return sqrt(dot(d, d) / (real(2.0) * max(real(1.0) - cosine, real(1e-6))));
}

// How far two samples are from the plane of one of them, the nearer of both, in shares of `width`: 0 on one plane at any
// distance and slope.
real agaa_planeStep(rvec3 offset, rvec3 normalA, rvec3 normalB, real width) {
    return min(abs(dot(normalA, offset)), abs(dot(normalB, offset))) / max(width, real(1e-30));
}

// A pixel's samples that show geometry, how many of them are shaded, both in [0, 32], and how far the others differ from these,
// [0, 1], in one word.
uint agaa_packCount(uint covered, uint count, real left) {
    return covered | count << 8u | uint(clamp(left, real(0.0), real(1.0)) * real(65535.0) + real(0.5)) << 16u;
}

uint agaa_coveredIn(uint word) { return word & 0xFFu; }
uint agaa_countIn(uint word) { return word >> 8u & 0xFFu; }
real agaa_leftIn(uint word) { return real(word >> 16u) / real(65535.0); }

// The mean of numbers of samples, of which `memory`, [0, 1), is kept from frame to frame; 0 begins anew.
real agaa_meanOfCounts(real mean, uint count, real memory) {
    return mean > real(0.0) && count != 0u ? real(count) + (mean - real(count)) * memory : real(count);
}

// Bins of a histogram of differences, eight to a power of two, from 1/16 of a threshold to 2^28 of them; the last one has no end.
uint agaa_bins() { return 256u; } // of this and of agaa_demandBin()
real agaa_leastDifference() { return real(0.0625); }

// difference: at least the least one.
uint agaa_differenceBin(real difference) {
    const real bin = floor(real(8.0) * log2(max(difference, agaa_leastDifference()) / agaa_leastDifference()));
    return uint(bin < real(255.0) ? bin : real(255.0)); // NaN and infinity: the last one
}

// Where a bin begins.
real agaa_differenceOfBin(uint bin) { return agaa_leastDifference() * exp2(real(bin) / real(8.0)); }

// Bins of a histogram of further samples, four to a sample.
uint agaa_demandBin(real further) {
    const real bin = floor(real(4.0) * max(further, real(0.0)));
    return uint(bin < real(255.0) ? bin : real(255.0));
}

// Up to the next power of two.
uint agaa_bucketOfCount(uint count) { return count < 2u ? count : uint(2) << uint(findMSB(count - 1u)); }

#endif
