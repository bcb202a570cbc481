// Shades each fragment of a pixel that shows at a sample, with the material that the host fetches by id. DCAA's reference.
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
#include "passes/shown_fragments.glsl"

agaa_Surface agaa_materialOf(uvec2 pixel, uint record, uvec4 mask, vec2 middle) {
    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
    agaa_moveTo(p, pixel, middle + 0.5);
    AgaaMaterial m = agaa_fetchMaterialThere(p);
    if (AGAA_NDF < agaa_ndfLean)
        agaa_widenByCurvature(m, mask);
    agaa_Surface s = agaa_surfaceOfMaterial(m);
    if (AGAA_NDF >= agaa_ndfLean)
        agaa_widenSurface(s, agaa_spreadOfFragment(s.normal, m.normalDx, m.normalDy, mask));
    return s;
}
#include "passes/shade_lists.glsl"
