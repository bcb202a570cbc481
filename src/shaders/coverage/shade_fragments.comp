// Shades each fragment of a pixel that shows at a sample. Materials are fetched by id. This is the reference for DCAA.
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
#include "coverage/shown_fragments.glsl"
#include "ids/fetched_custom.glsl"

agaa_Surface agaa_materialOf(uvec2 pixel, uint record, uvec4 mask, vec2 middle) {
    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
    agaa_evaluateAt(p, pixel, middle + 0.5);
    AgaaMaterial m = agaa_evaluateMaterial(p);
    agaa_setEventCustom(agaa_customOfMaterial(m));
    if (AGAA_NDF < agaa_ndfLean)
        agaa_widenByCurvature(m, mask);
    agaa_Surface s = agaa_surfaceOfMaterial(m);
    if (AGAA_NDF >= agaa_ndfLean)
        agaa_widenSurface(s, agaa_spreadOfFragment(s.normal, m.normalDx, m.normalDy, mask));
    return s;
}
#include "coverage/shade_lists.glsl"
