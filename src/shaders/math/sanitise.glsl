// Guards against NaN and infinity in materials of hosts.
// Source: hard cases 37 (one NaN poisons the aggregate) and 56 (guards a compiler cannot fold).
#ifndef AGAA_MATH_SANITISE_GLSL
#define AGAA_MATH_SANITISE_GLSL
#include "limits.glsl"
#include "real.glsl"

bool agaa_isFinite(real x) {
    return !agaa_exponentIsAllOnes(x);
}

bool agaa_isFinite3(rvec3 v) {
    return agaa_isFinite(v.x) && agaa_isFinite(v.y) && agaa_isFinite(v.z);
}

// Clamps finite values. Non-finite values become lo and set bad to 1, which other values do not change, so that one
// flag serves a whole material.
real agaa_sanitise(real x, real lo, real hi, INOUT(uint) bad) {
    real result = lo;
    if (agaa_isFinite(x)) {
        result = clamp(x, lo, hi);
    } else {
        bad = 1u;
    }
    return result;
}

rvec3 agaa_sanitise3(rvec3 v, real lo, real hi, INOUT(uint) bad) {
    rvec3 result = rvec3(lo, lo, lo);
    result.x = agaa_sanitise(v.x, lo, hi, bad);
    result.y = agaa_sanitise(v.y, lo, hi, bad);
    result.z = agaa_sanitise(v.z, lo, hi, bad);
    return result;
}

// Returns a value that a half float holds: 0 for NaN and negative infinity.
real agaa_representable(real x) {
    return agaa_isFinite(x) ? clamp(x, -AGAA_MAX_HALF, AGAA_MAX_HALF) : x > real(0.0) ? AGAA_MAX_HALF : real(0.0);
}

// The last guard of colours, which finite materials at non-finite positions reach.
rvec3 agaa_representableColor(rvec3 color) {
    return rvec3(agaa_representable(color.x), agaa_representable(color.y), agaa_representable(color.z));
}

// Returns radiance in [0, range]. Brighter emission is scaled so that its largest channel is `range`, because clamping
// each channel would shift its hue.
rvec3 agaa_sanitiseEmission(rvec3 v, real range, INOUT(uint) bad) {
    const rvec3 e = agaa_sanitise3(v, real(0.0), AGAA_MAX_FLOAT, bad);
    const real largest = max(e.x, max(e.y, e.z));
    // There is no branch, because lavapipe of Mesa 22.3 compiles a shader anew for each uniform value in its branches.
    const rvec3 hue = agaa_quotient3(e, max(largest, range));
    const rvec3 scaled = rvec3(hue.x * range, hue.y * range, hue.z * range);
    const bool isScaled = largest > range;
    return rvec3(isScaled ? scaled.x : e.x, isScaled ? scaled.y : e.y, isScaled ? scaled.z : e.z);
}

#endif
