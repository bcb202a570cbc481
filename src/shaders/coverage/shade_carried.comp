// Shades each fragment of a pixel that shows at a sample, with its material in the list. This is the reference for
// DCAA.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_VISIBILITY_WORDS 32u
#define AGAA_SAMPLE_WORDS AGAA_VISIBILITY_WORDS
#define AGAA_GROUPING_WORDS 0u
#define AGAA_FINDS_LIGHTS
#define AGAA_ORDERS_PIXELS
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "common/debug_view.glsl"
#include "common/tile_pixels.glsl"
#include "coverage/surface_position.glsl"
#include "coverage/material_lists.glsl"
#define AGAA_EMISSIVE_RANGE agaa_frame.emissiveRange
#include "aggregate/stored_means.glsl"

// Masks lose samples while other samples are not yet compared. The word by which the list was sorted keeps the depth at
// the centroid of all covered samples, which determines the range of depths.
void agaa_keepPlanes(uvec2 pixel, uint head) {
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        vec2 middle = agaa_coverageMiddle(agaa_maskOf(record), AGAA_SAMPLES);
        agaa_fragments.words[record + AGAA_FRAGMENT_DEPTH_AT] =
            floatBitsToUint(agaa_storedDepths(agaa_carriedPlane(record), middle).x);
        fragment = agaa_nextOf(record);
    }
}

agaa_DepthPlane agaa_listedPlane(uint record) {
    agaa_StoredPlane stored = agaa_carriedPlane(record);
    vec3 depths = agaa_storedDepths(stored, vec2(0.0));
    depths.x = uintBitsToFloat(agaa_fragments.words[record + AGAA_FRAGMENT_DEPTH_AT]);
    return agaa_planeOfDepths(stored, depths, true);
}
#include "coverage/list_visibility.glsl"

agaa_Surface agaa_materialOf(uvec2 pixel, uint record, uvec4 mask, vec2 middle) {
    agaa_Means m = agaa_meansOfStored(agaa_keptMaterial(record));
    agaa_setEventCustom(m);
    agaa_Surface s =
        agaa_Surface(m.diffuse, m.specular, m.emissive, agaa_keptNormal(record), 1.0, m.alpha2, 0.0, vec3(0.0));
    if (AGAA_SPREAD_WORDS != 0u)
        agaa_widenSurface(s, agaa_keptSpread(record));
    return s;
}
#include "coverage/shade_lists.glsl"
