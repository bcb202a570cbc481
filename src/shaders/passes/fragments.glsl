// Fragments in the lists of pixels, and the primitives that they are of.
#ifndef AGAA_FRAGMENTS_GLSL
#define AGAA_FRAGMENTS_GLSL
#include "math/coverage_pattern.glsl"
#include "math/depth_plane.glsl"
#include "passes/fetch.glsl"
#include "passes/fragment_layout.glsl"

#ifndef AGAA_LISTS_QUALIFIER
#define AGAA_LISTS_QUALIFIER // coherent: lanes read what others wrote
#endif
layout(std430, AGAA_AT_FRAGMENTS) AGAA_LISTS_QUALIFIER buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;
bool agaa_hasBatches() { return agaa_frame.counts.z > 1u; }
uint agaa_record(uint fragment) { return agaa_recordOf(fragment, agaa_frame.size.xy, agaa_hasBatches()); }

uvec4 agaa_maskOf(uint record) {
    uvec4 mask = uvec4(0u);
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        mask[word] = agaa_fragments.words[record + 2u + word];
    return mask;
}

agaa_DepthPlane agaa_planeOf(AgaaPrimitive p, uvec2 pixel) {
    vec2 pixelsPerNdc = 0.5 * vec2(agaa_frame.size.xy);
    vec3 z = vec3(p.a.z, p.b.z, p.c.z);
#if AGAA_CLIP_Z_FROM_MINUS_ONE
    z = 0.5 * (z + vec3(p.a.w, p.b.w, p.c.w));
#endif
    return agaa_depthPlane(agaa_vertexInPixels(p.a.xyw, pixelsPerNdc), agaa_vertexInPixels(p.b.xyw, pixelsPerNdc),
                           agaa_vertexInPixels(p.c.xyw, pixelsPerNdc), z, vec2(pixel) + 0.5);
}

// What is at the far plane is background.
bool agaa_isFar(agaa_DepthPlane plane) { return AGAA_FAR_DEPTH != 0u ? plane.range.x >= 1.0 : plane.range.y <= 0.0; }

// The plane as it is kept, with depths that grow away from the eye.
vec3 agaa_growingDepth(agaa_DepthPlane plane) { return agaa_planeInRange(plane) * (AGAA_FAR_DEPTH != 0u ? 1.0 : -1.0); }

// Of a curved primitive, normals spread over the samples that it covers: the mean normal is shorter by half of their variance.
void agaa_widenByCurvature(inout AgaaMaterial m, uvec4 mask) {
    if (AGAA_HAS_SPECULAR == 0u || AGAA_NDF == 0u)
        return;
    float share = float(agaa_coverageCount(mask)) / float(AGAA_SAMPLES);
    float variance = share * (dot(m.normalDx, m.normalDx) + dot(m.normalDy, m.normalDy)) / 12.0; // of a square pixel
    m.alpha2 = agaa_toksvigAlpha2(m.alpha2, max(1.0 - 0.5 * variance, 0.0));
}
#endif
