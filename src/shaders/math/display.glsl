// The display curve y = (x / (1 + x))^(1 / 2.2) of the tone-mapped image, in which colours are compared and filtered,
// and its inverse.
//
// Bright light has y near 1, where y keeps no digits of x: in float, 6e4 returned with an error of 45 %. So filters use
// the complement 1 - y, and compute 1 - (1 - u)^p without a difference of nearly equal numbers.
#ifndef AGAA_MATH_DISPLAY_GLSL
#define AGAA_MATH_DISPLAY_GLSL
#include "limits.glsl"
#include "real.glsl"

// Returns linear light as displayed. Negative values of a composited background count as 0.
rvec3 agaa_displayed(rvec3 linear) {
    const rvec3 light = max(linear, rvec3(real(0.0)));
    return pow(light / (real(1.0) + light), rvec3(real(1.0) / real(2.2)));
}

real agaa_displayLuma(rvec3 linear) {
    const rvec3 light = max(linear, rvec3(real(0.0)));
    return agaa_displayed(rvec3(dot(light, rvec3(real(0.2126), real(0.7152), real(0.0722))))).x;
}

// Returns the largest difference of two colours in a channel. Colours of equal luma differ (hard case 62).
real agaa_colorDifference(rvec3 a, rvec3 b) {
    const rvec3 d = abs(a - b);
    return max(d.x, max(d.y, d.z));
}

// Returns 1 - (1 - u)^p for u in [0, 1/8] and p > 0, by the binomial series.
real agaa_complementOfPower(real u, real p) {
    real sum = real(0.0);
    real term = p * u;
    for (uint k = 1u; k <= 8u; ++k) {
        sum += term;
        term *= (real(k) - p) * u / real(k + 1u);
    }
    return sum;
}

// Returns 1 - y of linear light, [0, AGAA_MAX_HALF]. Negative light counts as 0.
real agaa_displayComplement(real linear) {
    const real p = real(1.0) / real(2.2);
    const real x = clamp(linear, real(0.0), AGAA_MAX_HALF);
    const real u = real(1.0) / (real(1.0) + x);
    return u < real(0.125) ? agaa_complementOfPower(u, p) : real(1.0) - pow(x * u, p);
}

real agaa_linearFromDisplayComplement(real complement) {
    const real p = real(2.2);
    const real c = clamp(complement, real(0.0), real(1.0));
    const real y = pow(real(1.0) - c, p);
    const real u = c < real(0.125) ? agaa_complementOfPower(c, p) : real(1.0) - y;
    return min(y / max(u, real(1e-7)), AGAA_MAX_HALF);
}

// Interpolates two linear values in display space.
real agaa_mixDisplayed(real a, real b, real share) {
    const real from = agaa_displayComplement(a);
    return agaa_linearFromDisplayComplement(from + (agaa_displayComplement(b) - from) * share);
}

#endif
