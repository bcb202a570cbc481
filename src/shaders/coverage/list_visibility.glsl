// Which fragments of a list show at which samples: the depths of all fragments are compared at each sample. The including
// text defines agaa_keptPlane(record) and agaa_keepPlanes(pixel, head), after which planes are known.
#ifndef AGAA_LIST_VISIBILITY_GLSL
#define AGAA_LIST_VISIBILITY_GLSL
#include "math/coverage_pattern.glsl"

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
