// Shades each fragment of a pixel that shows at a sample, with the material that it carries. DCAA's reference.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/lighting.glsl"
#include "passes/output.glsl"
#include "passes/debug_view.glsl"
#include "passes/tile_pixels.glsl"
#include "passes/covered_place.glsl"
#include "passes/carried_fragments.glsl"
#define AGAA_EMISSIVE_RANGE agaa_frame.ambient.w
#include "passes/stored_means.glsl"

void agaa_keepPlanes(uvec2 pixel, uint head) {} // fragments carry them
#include "passes/list_visibility.glsl"

agaa_Surface agaa_materialOf(uvec2 pixel, uint record, uvec4 mask, vec2 middle) {
    agaa_Means m = agaa_meansOfStored(agaa_keptMaterial(record));
    agaa_Surface s = agaa_Surface(m.diffuse, m.specular, m.emissive, agaa_keptNormal(record), 1.0, m.alpha2, 0.0, vec3(0.0));
    if (AGAA_SPREAD_WORDS != 0u)
        agaa_widenSurface(s, agaa_keptSpread(record));
    return s;
}
#include "passes/shade_lists.glsl"
