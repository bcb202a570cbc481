// Merges the fragments of each pixel, whose materials are in the lists, into surfaces in memory (DCAA sections 3.2 and
// 3.3).
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
#include "coverage/material_lists.glsl"
#include "coverage/covered_surface.glsl"

bool agaa_readFragment(uvec2 pixel, uint record, out agaa_CoveredSurface s, out agaa_Stored material,
                       out agaa_NormalSpread spread) {
    agaa_StoredPlane plane = agaa_carriedPlane(record);
    s = agaa_surfaceOfWords(agaa_maskOf(record), floatBitsToUint(plane.depth), plane.slopes,
                            agaa_fragments.words[record + AGAA_PAYLOAD_AT + 2u]);
    material = agaa_keptMaterial(record);
    spread = agaa_keptSpread(record);
    return true;
}

vec2 agaa_listedRange(uvec2 pixel, uint record) { return agaa_keptPlane(record).range; }
#include "coverage/merge_lists.glsl"
