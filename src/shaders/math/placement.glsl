// The comparison of a fragment with the position that the host states for it (host/placement.glsl).
// Source: hard case 64 (comparisons with NaN are false).
#ifndef AGAA_MATH_PLACEMENT_GLSL
#define AGAA_MATH_PLACEMENT_GLSL
#include "real.glsl"
#include "sanitise.glsl"

// Returns whether a position is not that of its fragment. Positions that are not finite compare false with everything,
// so they are tested first.
// away      Distances of the position from the fragment in the image, in texels of the target.
// z         Of the position in view space.
// depthZ    z of the fragment's depth.
// slope     Change of z from texel to texel.
// quantum   Step of z that is a step of the depth format.
bool agaa_isElsewhere(rvec2 away, real z, real depthZ, real slope, real quantum) {
    // Positions inside a primitive are up to a pixel from the fragment's centre, and depth is quantised.
    const real apart = abs(depthZ - z) - (real(0.05) * abs(z) + real(2.0) * slope + real(4.0) * quantum);
    return !agaa_isFinite3(rvec3(away.x, away.y, z)) || max(away.x, away.y) > real(2.0) || apart > real(0.0);
}

#endif
