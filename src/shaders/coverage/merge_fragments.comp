// Merges the fragments of each pixel into surfaces in memory. Materials are fetched by id (DCAA sections 3.2 and 3.3).
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_ORDERS_PIXELS
layout(local_size_x = 8, local_size_y = 8) in;
#include "coverage/color_difference.glsl"
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "math/light.glsl"
#include "common/tile_pixels.glsl"
#include "coverage/sorted_list.glsl"
#include "coverage/covered_surface.glsl"
#include "ids/stored_material.glsl"
#include "coverage/surface_spread.glsl"

bool agaa_readFragment(uvec2 pixel, uint record, out agaa_CoveredSurface s, out agaa_Stored material,
                       out agaa_NormalSpread spread) {
    s.mask = agaa_maskOf(record);
    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
    agaa_DepthPlane plane = agaa_planeOf(p, pixel);
    if (agaa_isAtFarDepth(plane))
        return false;
    agaa_evaluateAt(p, pixel, agaa_coverageMiddle(s.mask, AGAA_SAMPLES) + 0.5);
    AgaaMaterial m = agaa_evaluateMaterial(p);
    if (AGAA_SPREAD_WORDS == 0u)
        agaa_widenByCurvature(m, s.mask);
    s = agaa_asStored(agaa_surfaceOfPlane(s.mask, agaa_growingDepth(plane), m.normal));
    material = agaa_storedMaterial(m);
    spread = agaa_noSpread(s.normal);
    if (AGAA_SPREAD_WORDS != 0u)
        spread = agaa_spreadOfFragment(s.normal, m.normalDx, m.normalDy, s.mask);
    return true;
}

// Returns the range as lists with materials have it, so that both merge the same fragments.
vec2 agaa_listedRange(uvec2 pixel, uint record) {
    vec2 middle = agaa_coverageMiddle(agaa_maskOf(record), AGAA_SAMPLES);
    agaa_DepthPlane plane = agaa_growingDepth(agaa_planeOf(agaa_primitive(agaa_fragments.words[record]), pixel));
    agaa_StoredPlane stored =
        agaa_storePlane(vec3(plane.depth, plane.slope), agaa_depthsOfRange(plane.range), middle);
    return agaa_loadedPlane(stored, middle, true).range;
}
#include "coverage/merge_lists.glsl"
