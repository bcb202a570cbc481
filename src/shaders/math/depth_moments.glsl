// Moments of depth that fragments sum in an aggregate: the mean and the variance of the depths of its samples. Codes
// are integers, so that the sums are exact and do not depend on the order of fragments.
// Source: AGAA (Crassin et al., TVCG 2016) sections 3.4.1 and 3.5.3; hard case 14.
#ifndef AGAA_MATH_DEPTH_MOMENTS_GLSL
#define AGAA_MATH_DEPTH_MOMENTS_GLSL
#include "depth.glsl"

// Codes have 22 bits. Their halves have 11, so that the sums of 32 halves fit 16 bits, and those of their products a
// word.
uint agaa_largestDepthCode() { return 0x3FFFFFu; }

// In a perspective view, codes are logarithms of the distance along the view from 2^-24 on, over 64 octaves: one step
// is 1e-5 of the distance.
real agaa_lowestOctave() { return real(-24.0); }
real agaa_depthOctaves() { return real(64.0); }

// Returns the code of a depth of the depth buffer. In an orthographic view it is linear.
uint agaa_depthCode(real d, real p22, real p32, uint orthographic) {
    real share = d;
    if (orthographic == 0u) {
        const real z = max(-agaa_viewZFromDepth(d, p22, p32, 0u), real(1e-25));
        share = (log2(z) - agaa_lowestOctave()) / agaa_depthOctaves();
    }
    return uint(agaa_saturate(share) * real(agaa_largestDepthCode()) + real(0.5));
}

// Returns what a code adds to sum m, [0, 3]: its halves, and the products of the halves.
uint agaa_depthTerm(uint m, uint code) {
    const uint high = code >> 11u;
    const uint low = code & 0x7FFu;
    uint term = high << 16u | low;
    if (m > 0u) {
        term = m == 1u ? high * high : (m == 2u ? high * low : low * low);
    }
    return term;
}

struct agaa_CodeMoments {
    real mean;
    real deviation; // the root of the variance
};

// Returns the moments of codes from their sums. Differences are taken to the whole part of the mean, so that they are
// small integers. count must be in [1, 32].
agaa_CodeMoments agaa_momentsOfCodes(uvec4 sums, uint count) {
    const uint highs = sums.x >> 16u;
    const uint lows = sums.x & 0xFFFFu;
    const uint sum = highs * 2048u + lows;
    const uint whole = sum / count;
    const uint high = whole >> 11u;
    const uint low = whole & 0x7FFu;
    const real n = real(count);
    const real rest = real(sum - whole * count) / n;
    // The sums of the squares and of the product of the halves' differences. Unsigned integers wrap to their values.
    const uint squareOfHighs = sums.y - 2u * high * highs + count * high * high;
    const uint squareOfLows = sums.w - 2u * low * lows + count * low * low;
    const uint product = sums.z - high * lows - low * highs + count * high * low;
    const real signedProduct = product < 0x80000000u ? real(product) : -real(0xFFFFFFFFu - product) - real(1.0);
    const real squares =
        real(4194304.0) * real(squareOfHighs) + real(4096.0) * signedProduct + real(squareOfLows);
    agaa_CodeMoments moments;
    moments.mean = real(whole) + rest;
    moments.deviation = sqrt(max(squares / n - rest * rest, real(0.0)));
    return moments;
}

// View z of an aggregate: the mean, and shadow taps along the view ray.
struct agaa_StoredDepth {
    real mean;
    real deviation;
    real nearest; // within which taps lie
    real farthest;
};

// Returns the view z of two depths with these moments, the distribution with the least extent. Its mean and deviation
// are exact where an aggregate is two surfaces with as many samples, and nearly where depths differ little.
agaa_StoredDepth agaa_storedDepth(agaa_CodeMoments codes, real p22, real p32, uint orthographic) {
    const real unit = real(1.0) / real(agaa_largestDepthCode());
    agaa_StoredDepth depth;
    if (orthographic != 0u) {
        const real slope = agaa_guardedReciprocal(p22);
        depth.mean = agaa_viewZFromDepth(codes.mean * unit, p22, p32, orthographic);
        depth.deviation = min(codes.deviation * unit * abs(slope), agaa_maxViewDistance());
        depth.nearest = depth.mean + depth.deviation;
        depth.farthest = depth.mean - depth.deviation;
    } else {
        const real octaves = unit * agaa_depthOctaves();
        const real middle = exp2(codes.mean * octaves + agaa_lowestOctave());
        // Half of the ratio of the two depths. Without a difference it is exactly 1.
        const real ratio = exp2(codes.deviation * octaves);
        const real inverse = real(1.0) / ratio;
        const real farther = min(middle * ratio, agaa_maxViewDistance());
        const real nearer = middle * inverse;
        depth.mean = real(-0.5) * (nearer + farther);
        depth.deviation = real(0.5) * (farther - nearer);
        depth.nearest = -nearer;
        depth.farthest = -farther;
    }
    return depth;
}
#endif
