// Position, shadows and widened lobe of a surface with coverage samples. Needs common/target.glsl and
// common/lighting.glsl.
#ifndef AGAA_SURFACE_POSITION_GLSL
#define AGAA_SURFACE_POSITION_GLSL
#if !defined(AGAA_TARGET_GLSL) || !defined(AGAA_LIGHTING_GLSL)
#error "surface_position.glsl needs target.glsl and lighting.glsl."
#endif
#include "tables/lighting.inc"
#include "math/surface_resolve.glsl"
#include "coverage/covered_surface.glsl"
#include "coverage/surface_spread.glsl"

// Returns the position of a depth plane in view space. offset: from the pixel's centre, in pixels.
vec3 agaa_viewPositionOf(uvec2 pixel, agaa_DepthPlane plane, vec2 offset) {
    float depth = agaa_deviceDepth(agaa_depthAt(plane, offset));
    return agaa_viewPositionAt(pixel, offset + 0.5, depth);
}

vec3 agaa_surfacePosition(uvec2 pixel, agaa_DepthPlane plane, vec2 offset) {
    return agaa_toShadingSpace(agaa_viewPositionOf(pixel, plane, offset));
}

// Returns the depth plane that shows at a sample. Includers that define the type AGAA_SHOWN define this function, too.
#ifdef AGAA_SHOWN
agaa_DepthPlane agaa_shownPlane(AGAA_SHOWN shown, uint sampleOf);
#else
#define AGAA_SHOWN agaa_DepthPlane
agaa_DepthPlane agaa_shownPlane(agaa_DepthPlane plane, uint sampleOf) { return plane; }
#endif

// Returns the mean squared distance of four of the samples, evenly chosen, from the position, and finds their
// footprint.
float agaa_spreadOfSurface(uvec2 pixel, AGAA_SHOWN shown, uvec4 mask, vec3 position) {
    uint count = agaa_coverageCount(mask);
    float sum = 0.0;
    agaa_beginFootprint();
    for (uint j = 0u; j < 4u; ++j) {
        uint sampleOf = agaa_coveredSample(mask, (2u * j + 1u) * count / 8u);
        vec3 away = agaa_surfacePosition(pixel, agaa_shownPlane(shown, sampleOf),
                                         agaa_coveragePosition(sampleOf, AGAA_SAMPLES)) -
                    position;
        sum += dot(away, away);
        agaa_addToFootprint(0.25, away);
    }
    return sum * 0.25;
}

// Finds the spread of the surface, and the visibility by shadow taps at up to AGAA_SHADOW_TAPS of the samples, evenly
// chosen, or at their centroid.
void agaa_tapSurface(uvec2 pixel, AGAA_SHOWN shown, uvec4 mask, vec3 position) {
    agaa_setEvent(pixel, mask);
    if (AGAA_HAS_FOOTPRINT || !agaa_hasFact(AGAA_FACT_NO_LOCAL_LIGHTS))
        agaa_setSpread(agaa_spreadOfSurface(pixel, shown, mask, position), position);
#if AGAA_SHADOWS
    uint count = agaa_coverageCount(mask);
    uint taps = AGAA_SHADOW_FILTER != AGAA_SHADOW_AT_MEAN ? min(count, AGAA_SHADOW_TAPS) : 1u;
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        agaa_visibility[map] = 0.0;
    if (taps == 1u)
        agaa_addTaps(position);
    for (uint j = 0u; j < taps && taps > 1u; ++j) {
        uint sampleOf = agaa_coveredSample(mask, (2u * j + 1u) * count / (2u * taps));
        agaa_addTaps(agaa_surfacePosition(pixel, agaa_shownPlane(shown, sampleOf),
                                          agaa_coveragePosition(sampleOf, AGAA_SAMPLES)));
    }
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        agaa_visibility[map] /= float(taps);
    agaa_lookUpFootprint(position);
#endif
}

// Widens the lobe of s, which is that of its material, by the spread of normals.
void agaa_widenSurface(inout agaa_Surface s, agaa_NormalSpread spread) {
    agaa_widenBySpread(spread, s.alpha2, AGAA_NDF == agaa_ndfSggx ? 1u : 0u, s.axis, s.alpha2Along, s.alpha2);
}
#endif
