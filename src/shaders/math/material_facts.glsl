// Decisions about materials for the facts of a view (common/scene_facts.glsl).
// Sources: hard cases 60 (masks decided by one tier otherwise) and 63 (absolute thresholds of emission).
#ifndef AGAA_MATH_MATERIAL_FACTS_GLSL
#define AGAA_MATH_MATERIAL_FACTS_GLSL
#include "real.glsl"

// Returns whether an alpha-masked surface of this cutoff is a cut-out, and not translucent. The facts of the view
// decide before the material does.
bool agaa_isCutoutByFacts(real cutoff, bool hasNoTranslucency, bool hasNoCutouts) {
    return hasNoTranslucency || (!hasNoCutouts && cutoff > real(0.0));
}

// Returns whether a material is emissive. range: of the layout. Emission has no other scale, because hosts multiply it
// by their exposure.
bool agaa_isEmissive(rvec3 emissive, real range) {
    const real least = range * real(7.6e-6); // half a step of 16 bits
    return max(emissive.x, max(emissive.y, emissive.z)) > least;
}

#endif
