// Reflectance lobes in forms that keep their digits in single precision.
// Sources: AGAA (Crassin et al., TVCG 2016) sections 3.5.1 and 3.5.2; Walter et al. 2007 (GGX);
// Heitz 2014, "Understanding the Masking-Shadowing Function" (height-correlated Smith); Schlick
// 1994; Blinn 1977; Ashikhmin and Shirley 2000; hard cases 8 and 58. The rectified diffuse is of no paper. It
// approximates the mean of max(n.l, 0) over Toksvig's distribution in closed form; tests/math/functions_test.cpp
// compares it with means over random normals. Filters of the diffuse term are those of section 3.5.2.
#ifndef AGAA_MATH_BRDF_GLSL
#define AGAA_MATH_BRDF_GLSL
#include "ndf.glsl"
#include "real.glsl"

// Returns log(1 + x) for x > -1 without the cancellation of 1 + x near x = 0. It uses the series of the inverse
// hyperbolic tangent, because a compiler that reassociates turns Kahan's (u-1) correction into x.
real agaa_log1p(real x) {
    real result = real(0.0);
    if (abs(x) < real(0.5)) {
        const real z = x / (real(2.0) + x);
        const real q = z * z;
        real p = real(1.0) / real(17.0);
        p = p * q + real(1.0) / real(15.0);
        p = p * q + real(1.0) / real(13.0);
        p = p * q + real(1.0) / real(11.0);
        p = p * q + real(1.0) / real(9.0);
        p = p * q + real(1.0) / real(7.0);
        p = p * q + real(1.0) / real(5.0);
        p = p * q + real(1.0) / real(3.0);
        p = p * q + real(1.0);
        result = real(2.0) * z * p;
    } else {
        result = log(max(real(1.0) + x, real(1e-37)));
    }
    return result;
}

// Returns GGX from |n x h|^2, because 1 - (n.h)^2 loses all digits for small alpha. The denominator of unit vectors
// cannot fall below alpha2, so the maximum 1/(pi alpha2) is a guard.
real agaa_ggxD(real alpha2, real NoH, real NxH2) {
    const real a2 = clamp(alpha2, agaa_minAlpha2(), real(1.0));
    const real c = max(NoH, real(0.0));
    const real d = max(max(NxH2, real(0.0)) + a2 * c * c, a2);
    return a2 / (agaa_pi() * d * d);
}

// Returns the height-correlated Smith visibility, G / (4 NoL NoV). If both cosines are 0, it is a large finite number.
real agaa_ggxV(real alpha2, real NoV, real NoL) {
    const real a2 = clamp(alpha2, agaa_minAlpha2(), real(1.0));
    const real v = agaa_saturate(NoV);
    const real l = agaa_saturate(NoL);
    const real maskV = l * sqrt(a2 + (real(1.0) - a2) * v * v);
    const real maskL = v * sqrt(a2 + (real(1.0) - a2) * l * l);
    return real(0.5) / max(maskV + maskL, real(1e-7));
}

// Returns GGX of an elliptic lobe. `along` is alpha2 in the direction of an axis perpendicular to the normal, `across`
// is alpha2 perpendicular to both. h has the half vector's components in that order, then that along the normal.
// Numerator and denominator are multiplied by the product of the widths, so that no quotient of small numbers is
// squared.
real agaa_ggxEllipseD(real along, real across, rvec3 h) {
    const real a = clamp(along, agaa_minAlpha2(), real(1.0));
    const real b = clamp(across, agaa_minAlpha2(), real(1.0));
    const real ab = a * b;
    const real up = max(h.z, real(0.0));
    const real d = max(b * h.x * h.x + a * h.y * h.y + ab * up * up, ab);
    return ab / (d * d) * sqrt(ab) / agaa_pi();
}

// Returns agaa_ggxV() with the widths in the directions of v and l (Heitz 2014). Components are in the order of
// agaa_ggxEllipseD().
real agaa_ggxEllipseV(real along, real across, rvec3 v, rvec3 l) {
    const real a = clamp(along, agaa_minAlpha2(), real(1.0));
    const real b = clamp(across, agaa_minAlpha2(), real(1.0));
    const real NoV = agaa_saturate(v.z);
    const real NoL = agaa_saturate(l.z);
    const real maskV = NoL * sqrt(a * v.x * v.x + b * v.y * v.y + NoV * NoV);
    const real maskL = NoV * sqrt(a * l.x * l.x + b * l.y * l.y + NoL * NoL);
    return real(0.5) / max(maskV + maskL, real(1e-7));
}

rvec3 agaa_fresnelSchlick(rvec3 f0, real VoH) {
    const real m = real(1.0) - agaa_saturate(VoH);
    const real m2 = m * m;
    const real m5 = m2 * m2 * m;
    return rvec3(f0.x + (real(1.0) - f0.x) * m5, f0.y + (real(1.0) - f0.y) * m5,
                 f0.z + (real(1.0) - f0.z) * m5);
}

// Returns the Blinn-Phong distribution (s+2)/(2 pi) (n.h)^s, which integrates to 1 against n.h. pow() of a cosine near
// 1 loses all digits at high exponents, so the logarithm is computed from |n x h|^2 there, and from the cosine if that
// is small.
real agaa_blinnPhong(real exponent, real NxH2, real NoH) {
    const real s = max(exponent, real(0.0));
    real d = real(0.0);
    if (NoH > real(0.0)) {
        real logCosine = real(0.0);
        if (NxH2 < real(0.5)) {
            logCosine = real(0.5) * agaa_log1p(-max(NxH2, real(0.0)));
        } else {
            logCosine = log(clamp(NoH, real(1e-30), real(1.0)));
        }
        // exp() is 0 below -87. The bound keeps its argument in the range where it is exact.
        d = (s + real(2.0)) / (real(2.0) * agaa_pi()) * exp(max(s * logCosine, real(-80.0)));
    }
    return d;
}

// Returns Blinn-Phong of an elliptic lobe (Ashikhmin and Shirley 2000). The exponent is the mean of those of both axes,
// weighted by the direction of n x h.
real agaa_blinnPhongEllipse(real along, real across, rvec3 h) {
    const real a = agaa_exponentFromAlpha2(along);
    const real b = agaa_exponentFromAlpha2(across);
    const real x2 = h.x * h.x;
    const real y2 = h.y * h.y;
    const real off = x2 + y2;
    real exponent = b;
    if (off > real(1e-20)) {
        exponent = (a * x2 + b * y2) / off;
    }
    const real isotropic = agaa_blinnPhong(exponent, min(off, real(1.0)), h.z);
    return isotropic * sqrt((a + real(2.0)) * (b + real(2.0))) / (exponent + real(2.0));
}

// Returns the mean of max(n.l, 0) over the normals of an aggregate, from their mean Na: NoL_mean = dot(Na, l) and
// noL_unit = dot(Na/|Na|, l). At length 1 it is exactly max(NoL_mean, 0).
real agaa_rectifiedDiffuse(real NoL_mean, real noL_unit, real meanLength) {
    const real len = agaa_saturate(meanLength);
    const real u2 = min(noL_unit * noL_unit, real(1.0));
    const real across = (real(1.0) - len) * (real(1.0) + len) * (real(1.0) - u2);
    const real along = agaa_sq(real(1.0) - len) * u2;
    // 0.6366 is 2/pi: at mu = 0 the result is the mean of a rectified Gaussian, s/sqrt(2 pi).
    const real spread = real(0.63661977236758134) * real(0.5) * (across + along);
    real d = max(NoL_mean, real(0.0));
    if (spread > real(0.0)) {
        const real root = sqrt(NoL_mean * NoL_mean + spread);
        if (NoL_mean >= real(0.0)) {
            d = real(0.5) * (NoL_mean + root);
        } else {
            // The value is the same. NoL_mean + root would cancel for a mean that faces away.
            d = real(0.5) * spread / (root - NoL_mean);
        }
    }
    return d;
}

// Returns the mean of max(n.l, 0) over a von Mises-Fisher distribution of normals whose mean has this length. Wide
// distributions take the first spherical harmonics of the cosine, whose factors are 1, len and 2 len^2 / (3 - len^2),
// narrow ones the fit of Hill (in Pettineo 2016, "SG Series Part 3: Diffuse Lighting From an SG Light Source").
real agaa_misesFisherDiffuse(real noL_unit, real meanLength) {
    const real len = agaa_saturate(meanLength);
    const real c = clamp(noL_unit, real(-1.0), real(1.0));
    const real spread = real(1.0) - len * len;
    real d = max(c, real(0.0));
    if (spread > real(1e-6)) {
        const real second = real(2.0) * len * len / (real(3.0) - len * len);
        const real wide = real(0.25) + real(0.5) * len * c +
                          real(0.3125) * second * (real(1.5) * c * c - real(0.5));
        // The sharpness of a distribution of this length (Banerjee et al. 2005). Below 1, `narrow` has no share.
        const real sharpness = max(len * (real(3.0) - len * len) / spread, real(1.0));
        const real inverse = real(1.0) / sharpness;
        const real once = exp(-sharpness);
        const real twice = once * once;
        const real scale = real(1.0) + real(2.0) * twice - inverse;
        const real bias = (once - twice) * inverse - twice;
        const real x = sqrt(max(real(1.0) - scale, real(0.0)));
        const real x0 = real(0.36) * c;
        const real x1 = real(0.25) / real(0.36) * x;
        const real y = abs(x0) <= x1 ? agaa_sq(x0 + x1) / x : agaa_saturate(c);
        const real narrow = max(scale * y + bias, real(0.0));
        d = mix(wide, narrow, agaa_saturate((len - real(0.5)) * real(4.0)));
    }
    return d;
}

#endif
