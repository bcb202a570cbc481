// Lists of fragments with their materials. Needs what coverage/fragment_words.glsl needs.
#ifndef AGAA_MATERIAL_LISTS_GLSL
#define AGAA_MATERIAL_LISTS_GLSL
#define AGAA_MATERIAL_LISTS
#include "coverage/material_payload.glsl"
#define AGAA_PAYLOAD_WORDS AGAA_MATERIAL_PAYLOAD_WORDS
#include "math/coverage_pattern.glsl"
#include "math/stored_plane.glsl"
#include "coverage/list_order.glsl"
#include "coverage/surface_spread.glsl"
#include "aggregate/unpacking.glsl"

agaa_StoredPlane agaa_carriedPlane(uint record) {
    uint at = record + AGAA_PAYLOAD_AT;
    return agaa_StoredPlane(uintBitsToFloat(agaa_fragments.words[at]), agaa_fragments.words[at + 1u]);
}

// The mask may have lost samples that other fragments hide.
agaa_DepthPlane agaa_keptPlane(uint record) {
    return agaa_loadedPlane(agaa_carriedPlane(record), agaa_coverageMiddle(agaa_maskOf(record), AGAA_SAMPLES), true);
}

vec3 agaa_keptNormal(uint record) { return agaa_unpackNormal(agaa_fragments.words[record + AGAA_PAYLOAD_AT + 2u]); }

agaa_NormalSpread agaa_keptSpread(uint record) {
    uint at = record + AGAA_PAYLOAD_AT + AGAA_PLANE_WORDS;
    vec3 normal = agaa_keptNormal(record);
    return AGAA_SPREAD_WORDS == 0u
               ? agaa_noSpread(normal)
               : agaa_unpackSpread(normal, uvec2(agaa_fragments.words[at], agaa_fragments.words[at + 1u]));
}

agaa_Stored agaa_keptMaterial(uint record) {
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_packed[w] = agaa_fragments.words[record + AGAA_PAYLOAD_AT + AGAA_PLANE_WORDS + AGAA_SPREAD_WORDS + w];
    return agaa_unpackSurface();
}
#endif
