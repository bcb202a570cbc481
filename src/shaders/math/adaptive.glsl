// Metrics of adaptive sampling: the number of shaded samples of a pixel, and the differences that choose them.
// Sources: Hollaender et al. 2013, "Adaptive Supersampling for Deferred Anti-Aliasing", section 3.1; hard cases 12, 13,
// 15 and 43.
#ifndef AGAA_MATH_ADAPTIVE_GLSL
#define AGAA_MATH_ADAPTIVE_GLSL
#include "real.glsl"

// Returns k_s: c times the range of luminances, 0 if the range does not exceed the thresholds.
real agaa_shadingCount(real lowest, real highest, real relative, real absolute, real c) {
    const real range = highest - lowest;
    return range < max(absolute, highest * relative) ? real(0.0) : c * range;
}

// Returns k rounded up, in [least, most]. k may be infinite or NaN.
uint agaa_wholeCount(real k, uint least, uint most) {
    const real bounded = k < real(most) ? ceil(max(k, real(least))) : real(most); // NaN: most
    return uint(bounded);
}

// Returns the difference of two unit normals relative to the angle with this cosine. |a - b|^2 / 2 is 1 - a.b without
// cancellation. Opposite normals differ.
real agaa_normalStep(rvec3 a, rvec3 b, real cosine) {
    const rvec3 d = a - b;
    return sqrt(dot(d, d) / (real(2.0) * max(real(1.0) - cosine, real(1e-6))));
}

// Returns the distance of two samples from the plane of one of them, the smaller of both, relative to `width`. It is 0
// on one plane at any distance and slope.
real agaa_planeStep(rvec3 offset, rvec3 normalA, rvec3 normalB, real width) {
    return min(abs(dot(normalA, offset)), abs(dot(normalB, offset))) / max(width, real(1e-30));
}

// Packs a pixel's choice in one word.
// covered   Number of samples with geometry, [0, 32].
// count     Number of shaded samples, [0, 32].
// left      Difference of the other samples from these, [0, 1].
uint agaa_packCount(uint covered, uint count, real left) {
    return covered | count << 8u | uint(clamp(left, real(0.0), real(1.0)) * real(65535.0) + real(0.5)) << 16u;
}

uint agaa_coveredIn(uint word) { return word & 0xFFu; }
uint agaa_countIn(uint word) { return word >> 8u & 0xFFu; }
real agaa_leftIn(uint word) { return real(word >> 16u) / real(65535.0); }

// Returns the mean of sample counts, of which the share `memory`, [0, 1), is kept per frame. A mean or count of 0
// restarts it.
real agaa_meanOfCounts(real mean, uint count, real memory) {
    return mean > real(0.0) && count != 0u ? real(count) + (mean - real(count)) * memory : real(count);
}

// Histograms of differences have eight bins per power of two, from 1/16 of a threshold to 2^28 thresholds. The last bin
// is open.
#define AGAA_BINS 256u // of both kinds of histogram
uint agaa_bins() { return AGAA_BINS; }
real agaa_leastDifference() { return real(0.0625); }

// Returns the bin of a difference, which must not be below the lowest one.
uint agaa_differenceBin(real difference) {
    const real bin = floor(real(8.0) * log2(max(difference, agaa_leastDifference()) / agaa_leastDifference()));
    const real last = real(AGAA_BINS - 1u);
    return uint(bin < last ? bin : last); // NaN and infinity: the last one
}

// Returns the lowest difference of a bin.
real agaa_differenceOfBin(uint bin) { return agaa_leastDifference() * exp2(real(bin) / real(8.0)); }

// Returns the bin in a histogram of further samples, which has four bins per sample.
uint agaa_demandBin(real further) {
    const real bin = floor(real(4.0) * max(further, real(0.0)));
    const real last = real(AGAA_BINS - 1u);
    return uint(bin < last ? bin : last);
}

// Returns the count rounded up to a power of two.
uint agaa_bucketOfCount(uint count) { return count < 2u ? count : uint(2) << uint(findMSB(count - 1u)); }

#endif
