// Lookup and clipping of the image of earlier frames (Karis 2014; Salvi 2016).
#ifndef AGAA_MATH_HISTORY_GLSL
#define AGAA_MATH_HISTORY_GLSL
#include "limits.glsl"
#include "real.glsl"

// Colours are compared as luma and chroma (YCoCg), after a curve that compresses bright light: c / (1 + luma).

real agaa_lightLuma(rvec3 c) { return real(0.25) * (c.x + c.z) + real(0.5) * c.y; }

rvec3 agaa_compressedYCoCg(rvec3 linear) {
    const rvec3 c = linear / (real(1.0) + agaa_lightLuma(linear));
    return rvec3(agaa_lightLuma(c), real(0.5) * (c.x - c.z), real(0.5) * c.y - real(0.25) * (c.x + c.z));
}

// Returns linear light, not negative and at most AGAA_MAX_HALF.
rvec3 agaa_linearFromCompressed(rvec3 yCoCg) {
    const real base = yCoCg.x - yCoCg.z;
    const rvec3 c = rvec3(base + yCoCg.y, yCoCg.x + yCoCg.z, base - yCoCg.y);
    const real rest = max(real(1.0) - yCoCg.x, real(1.0) / (real(1.0) + AGAA_MAX_HALF));
    return min(max(c / rest, rvec3(real(0.0))), rvec3(AGAA_MAX_HALF));
}

// Returns the share of the way from a box's centre to a point outside that remains within the box; 1 inside.
real agaa_shareWithin(rvec3 fromCentre, rvec3 halfSize) {
    const rvec3 d = abs(fromCentre);
    real share = real(1.0);
    if (d.x > halfSize.x)
        share = min(share, halfSize.x / d.x);
    if (d.y > halfSize.y)
        share = min(share, halfSize.y / d.y);
    if (d.z > halfSize.z)
        share = min(share, halfSize.z / d.z);
    return share;
}

// Returns the weights of four texels around a position, by the cubic of Catmull and Rom.
// x   position after the second texel, [0, 1].
rvec4 agaa_catmullRom(real x) {
    const real y = real(1.0) - x;
    const rvec4 w = rvec4(real(-0.5) * x * y * y, real(1.0) + x * x * (real(1.5) * x - real(2.5)),
                          real(1.0) + y * y * (real(1.5) * y - real(2.5)), real(-0.5) * y * x * x);
    return w;
}

// A motion vector in two channels of 16 bits: 0 where there is none, else the displacement in views.
real agaa_decodedMotion(real stored) {
    return (stored * real(65535.0) - real(32768.0)) / real(32767.0);
}

#endif
