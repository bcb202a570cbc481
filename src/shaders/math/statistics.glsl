// Mean and variance over the samples of an aggregate, and functions of shadows and metrics that use them.
// Sources: AGAA (Crassin et al., TVCG 2016) sections 3.4.1 and 3.5.3; Hollaender et al. 2013
// (adaptive image-space sampling metrics); hard cases 12, 13, 14 and 19.
#ifndef AGAA_MATH_STATISTICS_GLSL
#define AGAA_MATH_STATISTICS_GLSL
#include "real.glsl"

// Sums of differences to `shift`, which should be the first of the samples. E[x^2] - E[x]^2 of the values cancels if
// the mean exceeds the spread by a few thousand.
struct agaa_Moments {
    real shift;
    real sum;
    real sumSq;
    real count;
};

agaa_Moments agaa_momentsInit(real shift) {
    agaa_Moments m;
    m.shift = shift;
    m.sum = real(0.0);
    m.sumSq = real(0.0);
    m.count = real(0.0);
    return m;
}

void agaa_momentsAdd(INOUT(agaa_Moments) m, real x) {
    const real d = x - m.shift;
    m.sum = m.sum + d;
    m.sumSq = m.sumSq + d * d;
    m.count = m.count + real(1.0);
}

// Returns the variance. It is never negative, and exactly 0 for one sample, even with contraction by compilers.
real agaa_momentsVariance(agaa_Moments m) {
    real variance = real(0.0);
    if (m.count > real(1.5)) {
        const real mean = m.sum / m.count;
        variance = max(m.sumSq / m.count - mean * mean, real(0.0));
    }
    return variance;
}

// Returns the depth of shadow tap j of four along the view ray. Taps have equal weights and are at +-0.45 and +-1.34
// sigma, so that their spread is that of a Gaussian. They stay between the nearest and the farthest sample, which a
// Gaussian would exceed.
real agaa_depthTap(uint j, real mean, real sigma, real lowest, real highest) {
    const real quantile = j < 2u ? real(0.45) : real(1.34);
    const real offset = (j & 1u) != 0u ? sigma * quantile : -sigma * quantile;
    return clamp(mean + offset, lowest, highest);
}

// Returns the normal metric of a sample count: sqrt(1 - smallest n.n). The dot products are those of normals that face
// the viewer and have signs, so that an opposite normal counts as different. Rounded unit vectors have products above
// 1, whose root would be NaN.
real agaa_normalMetric(real smallestDot) {
    return sqrt(max(real(1.0) - smallestDot, real(0.0)));
}

#endif
