// Surfaces of `dcaa` and `sgbc` in memory. A surface has these words: coverage, depth plane (two words,
// math/stored_plane.glsl), normal (octahedral, 16 bits each), with elliptic lobes the spread of normals
// (coverage/surface_spread.glsl), then the material (aggregate/packing.glsl). A coverage of 0 means no surface. Depths
// increase away from the eye; reversed depths are negated. In `sgbc` the depths of samples follow behind all surfaces.
// Needs common/frame.glsl, and AGAA_AGGREGATES, AGAA_FAR_DEPTH, AGAA_SPREAD_WORDS and AGAA_STRIDE, which
// common/constants.glsl has.
#ifndef AGAA_COVERED_SURFACE_GLSL
#define AGAA_COVERED_SURFACE_GLSL
#ifndef AGAA_FRAME_GLSL
#error "covered_surface.glsl needs frame.glsl."
#endif
#ifndef AGAA_CONSTANTS_GLSL
#if !defined(AGAA_AGGREGATES) || !defined(AGAA_FAR_DEPTH) || !defined(AGAA_SPREAD_WORDS) || !defined(AGAA_STRIDE)
#error "covered_surface.glsl needs AGAA_AGGREGATES, AGAA_FAR_DEPTH, AGAA_SPREAD_WORDS and AGAA_STRIDE."
#endif
#endif
#include "math/surface_merge.glsl"
#include "math/stored_plane.glsl"
#include "coverage/packed_normals.glsl"
#include "tables/layouts.inc"

#define AGAA_MASK_WORDS (AGAA_SAMPLES / 32u)
#define AGAA_DEPTH_WORD AGAA_MASK_WORDS
#define AGAA_SLOPE_WORD (AGAA_MASK_WORDS + 1u)
#define AGAA_NORMAL_WORD (AGAA_MASK_WORDS + 2u)
#define AGAA_SPREAD_WORD (AGAA_MASK_WORDS + AGAA_PLANE_WORDS)
#define AGAA_MATERIAL_WORD (AGAA_SPREAD_WORD + AGAA_SPREAD_WORDS)

#ifndef AGAA_IN_TARGETS
#define AGAA_IN_TARGETS 0
#endif

// Returns the index of the first word of surface a: in the buffer, or with AGAA_IN_TARGETS among the words of the
// pixel.
uint agaa_surfaceBase(uvec2 pixel, uint a) {
#if AGAA_IN_TARGETS
    return a * AGAA_STRIDE;
#else
    return ((pixel.y * agaa_frame.size.x + pixel.x) * AGAA_AGGREGATES + a) * AGAA_STRIDE;
#endif
}

#if !AGAA_IN_TARGETS
// Returns the index of a word behind all surfaces: the depth bound of the pixel, where AGAA_NORMALISES is set.
uint agaa_boundOfSurfaces(uvec2 pixel) {
    uvec2 size = agaa_frame.size;
    return size.x * size.y * AGAA_AGGREGATES * AGAA_STRIDE + pixel.y * size.x + pixel.x;
}

// Returns the index of the words behind all surfaces that have the depths of the pixel's samples, where AGAA_STREAMS is
// set.
uint agaa_nearestDepthsOf(uvec2 pixel) {
    uvec2 size = agaa_frame.size;
    return size.x * size.y * AGAA_AGGREGATES * AGAA_STRIDE + (pixel.y * size.x + pixel.x) * AGAA_SAMPLES;
}
#endif

agaa_CoveredSurface agaa_surfaceOfWords(uvec4 mask, uint depth, uint slopes, uint normal) {
    agaa_StoredPlane stored = agaa_StoredPlane(uintBitsToFloat(depth), slopes);
    return agaa_CoveredSurface(mask, agaa_storedPlane(stored),
                               agaa_storedDepths(stored, agaa_coverageMiddle(mask, AGAA_SAMPLES)),
                               agaa_unpackNormal(normal));
}

agaa_CoveredSurface agaa_surfaceOfPlane(uvec4 mask, agaa_DepthPlane plane, vec3 normal) {
    return agaa_CoveredSurface(mask, vec3(plane.depth, plane.slope), agaa_depthsOfRange(plane.range), normal);
}

agaa_StoredPlane agaa_storedPlaneOf(agaa_CoveredSurface s) {
    return agaa_storePlane(s.plane, s.depths, agaa_coverageMiddle(s.mask, AGAA_SAMPLES));
}

// Returns the surface as it is after storing and loading. To store it again does not change it.
agaa_CoveredSurface agaa_asStored(agaa_CoveredSurface s) {
    agaa_StoredPlane stored = agaa_storedPlaneOf(s);
    return agaa_surfaceOfWords(s.mask, floatBitsToUint(stored.depth), stored.slopes, agaa_packNormal(s.normal));
}

// Converts a depth that increases away from the eye to that of the depth buffer.
float agaa_deviceDepth(float depth) { return AGAA_FAR_DEPTH != 0u ? depth : -depth; }
#endif
