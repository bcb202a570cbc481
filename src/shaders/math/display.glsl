// The display curve y = (x / (1 + x))^(1 / 2.2), which filters apply to colours, and its inverse.
//
// Bright light has y near 1, where y keeps no digits of x: in float, 6e4 returned with an error of 45 %. So functions
// use the complement 1 - y, and compute 1 - (1 - u)^p without a difference of nearly equal numbers.
#ifndef AGAA_MATH_DISPLAY_GLSL
#define AGAA_MATH_DISPLAY_GLSL
#include "limits.glsl"
#include "real.glsl"

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
