// Visibility of the fragments of a list by the planes of their primitives. Needs what coverage/sorted_list.glsl needs.
#ifndef AGAA_SHOWN_FRAGMENTS_GLSL
#define AGAA_SHOWN_FRAGMENTS_GLSL
#include "coverage/sorted_list.glsl"

vec3 agaa_keptPlane(uint record) {
    uint at = record + AGAA_PAYLOAD_AT;
    return vec3(uintBitsToFloat(agaa_fragments.words[at]), uintBitsToFloat(agaa_fragments.words[at + 1u]),
                uintBitsToFloat(agaa_fragments.words[at + 2u]));
}

// Stores the planes of all fragments. Fragments at the far plane cover no sample.
void agaa_keepPlanes(uvec2 pixel, uint head) {
    uint fragment = head;
    while (fragment != 0u) {
        uint record = agaa_record(fragment);
        agaa_DepthPlane plane = agaa_planeOf(agaa_primitive(agaa_fragments.words[record]), pixel);
        vec3 kept = agaa_growingDepth(plane);
        for (uint k = 0u; k < AGAA_KEPT_PLANE_WORDS; ++k)
            agaa_fragments.words[record + AGAA_PAYLOAD_AT + k] = floatBitsToUint(kept[k]);
        if (agaa_isAtFarDepth(plane))
            agaa_setMask(record, uvec4(0u));
        fragment = agaa_nextOf(record);
    }
}

#include "coverage/list_visibility.glsl"
#endif
