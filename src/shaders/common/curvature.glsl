// Curvature of primitives, from the screen-space derivatives of their normals.
#ifndef AGAA_CURVATURE_GLSL
#define AGAA_CURVATURE_GLSL
#include "math/coverage_pattern.glsl"
#include "math/ndf.glsl"
#include "math/sanitise.glsl"

// Replaces non-finite and negligible derivatives by 0 and limits the others. Returns 1 if a value is not finite.
uint agaa_sanitiseNormalChange(inout vec3 dx, inout vec3 dy) {
    bool isKnown = agaa_isFinite3(dx) && agaa_isFinite3(dy);
    float steepest = isKnown ? max(dot(dx, dx), dot(dy, dy)) : 0.0;
    // Changes too small to widen a lobe count as 0, so that flat primitives take the fast path in spite of rounding.
    // Normals change by at most one unit per pixel.
    float scale = steepest < 1e-8 || !agaa_isFinite(steepest) ? 0.0 : min(inversesqrt(steepest), 1.0);
    dx = scale > 0.0 ? scale * dx : vec3(0.0);
    dy = scale > 0.0 ? scale * dy : vec3(0.0);
    return isKnown ? 0u : 1u;
}

// Returns alpha2 widened by the spread of normals over the samples that a primitive covers. The mean normal is shorter
// than 1 by half of their variance.
float agaa_widenedByCurvature(float alpha2, vec3 dx, vec3 dy, uvec4 mask) {
    if (AGAA_HAS_SPECULAR == 0u || AGAA_NDF == agaa_ndfNone)
        return alpha2;
    float share = float(agaa_coverageCount(mask)) / float(AGAA_SAMPLES);
    float variance = share * (dot(dx, dx) + dot(dy, dy)) / 12.0; // of a square pixel
    return agaa_toksvigAlpha2(alpha2, max(1.0 - 0.5 * variance, 0.0));
}
#endif
