// Visibility of the fragments of a list by the planes of their primitives. Needs what coverage/sorted_list.glsl needs.
#ifndef AGAA_SHOWN_FRAGMENTS_GLSL
#define AGAA_SHOWN_FRAGMENTS_GLSL
#include "math/stored_plane.glsl"
#include "coverage/sorted_list.glsl"

agaa_DepthPlane agaa_keptPlane(uint record) {
    uint at = record + AGAA_PAYLOAD_AT;
    float depth = uintBitsToFloat(agaa_fragments.words[at]);
    vec2 slope = vec2(uintBitsToFloat(agaa_fragments.words[at + 1u]), uintBitsToFloat(agaa_fragments.words[at + 2u]));
    return agaa_DepthPlane(depth, slope, agaa_unpackRange(depth, slope, agaa_fragments.words[at + 3u]));
}

agaa_DepthPlane agaa_listedPlane(uint record) { return agaa_keptPlane(record); }

// Stores the planes of all fragments. Fragments at the far plane cover no sample.
void agaa_keepPlanes(uvec2 pixel, uint head) {
    uint fragment = head;
    while (fragment != 0u) {
        uint record = agaa_record(fragment);
        agaa_DepthPlane plane = agaa_planeOf(agaa_primitive(agaa_fragments.words[record]), pixel);
        agaa_DepthPlane kept = agaa_growingDepth(plane);
        uint at = record + AGAA_PAYLOAD_AT;
        agaa_fragments.words[at] = floatBitsToUint(kept.depth);
        agaa_fragments.words[at + 1u] = floatBitsToUint(kept.slope.x);
        agaa_fragments.words[at + 2u] = floatBitsToUint(kept.slope.y);
        agaa_fragments.words[at + 3u] = agaa_packRange(kept);
        if (agaa_isAtFarDepth(plane))
            agaa_setMask(record, uvec4(0u));
        fragment = agaa_nextOf(record);
    }
}

#include "coverage/list_visibility.glsl"
#endif
