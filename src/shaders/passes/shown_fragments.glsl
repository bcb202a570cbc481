// Which fragments of a list show at which samples: the depths of all fragments are compared at each sample.
#ifndef AGAA_SHOWN_FRAGMENTS_GLSL
#define AGAA_SHOWN_FRAGMENTS_GLSL
#include "passes/sorted_list.glsl"

#define AGAA_PLANE_WORD (2u + AGAA_SAMPLES / 32u)

vec3 agaa_keptPlane(uint record) {
    uint at = record + AGAA_PLANE_WORD;
    return vec3(uintBitsToFloat(agaa_fragments.words[at]), uintBitsToFloat(agaa_fragments.words[at + 1u]),
                uintBitsToFloat(agaa_fragments.words[at + 2u]));
}

void agaa_setMask(uint record, uvec4 mask) {
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        agaa_fragments.words[record + 2u + word] = mask[word];
}

uint agaa_nextOf(uint record) { return agaa_fragments.words[record + 1u]; }

// Keeps the planes of all fragments. What is at the far plane covers nothing.
void agaa_keepPlanes(uvec2 pixel, uint head) {
    uint fragment = head;
    while (fragment != 0u) {
        uint record = agaa_record(fragment);
        agaa_DepthPlane plane = agaa_planeOf(agaa_primitive(agaa_fragments.words[record]), pixel);
        vec3 kept = agaa_growingDepth(plane);
        for (uint k = 0u; k < 3u; ++k)
            agaa_fragments.words[record + AGAA_PLANE_WORD + k] = floatBitsToUint(kept[k]);
        if (agaa_isFar(plane))
            agaa_setMask(record, uvec4(0u));
        fragment = agaa_nextOf(record);
    }
}

// Of each sample at hand, the nearest depth and its fragment.
float agaa_nearestDepth[AGAA_SAMPLES];
uint agaa_nearestFragment[AGAA_SAMPLES];

// Lets samples of a fragment take it where it is the nearest, or, where they are decided, takes from it all others. Loops are
// over samples that fragments cover, not over pairs of fragments: software rasterisers of Mesa end all loops of an invocation
// once they have turned 65535 times together.
void agaa_resolveFragment(uint fragment, uint record, bool isDecided) {
    uvec4 mask = agaa_maskOf(record);
    vec3 plane = agaa_keptPlane(record);
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word) {
        uint left = mask[word];
        while (left != 0u) {
            uint bit = left & (~left + 1u);
            uint i = word * 32u + uint(findLSB(left));
            vec2 at = agaa_coveragePosition(i, AGAA_SAMPLES);
            float depth = plane.x + (plane.y * at.x + plane.z * at.y);
            uint other = agaa_nearestFragment[i];
            if (isDecided) {
                mask[word] ^= other != fragment ? bit : 0u;
            } else if (other == 0u || depth < agaa_nearestDepth[i]) {
                agaa_nearestDepth[i] = depth;
                agaa_nearestFragment[i] = fragment;
            }
            left ^= bit;
        }
    }
    if (isDecided)
        agaa_setMask(record, mask);
}

// Leaves each fragment the samples that show it; of equal depths the lower id shows. Returns the first fragment.
uint agaa_resolveList(uvec2 pixel) {
    uint head = agaa_sortList(pixel);
    agaa_keepPlanes(pixel, head);
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        agaa_nearestFragment[i] = 0u;
    for (uint turn = 0u; turn < 2u; ++turn) {
        uint fragment = head;
        while (fragment != 0u) {
            uint record = agaa_record(fragment);
            agaa_resolveFragment(fragment, record, turn == 1u);
            fragment = agaa_nextOf(record);
        }
    }
    return head;
}
#endif
