// Visibility of the fragments of a list: their depths are compared at each sample. The includer defines
// agaa_keptPlane(record) and agaa_keepPlanes(pixel, head), which is called before planes are read. Needs
// coverage/list_order.glsl.
#ifndef AGAA_LIST_VISIBILITY_GLSL
#define AGAA_LIST_VISIBILITY_GLSL
#ifndef AGAA_LIST_ORDER_GLSL
#error "list_visibility.glsl needs list_order.glsl."
#endif
#include "math/coverage_pattern.glsl"

// The nearest depth at each sample of the current pixel, and its fragment.
float agaa_nearestDepth[AGAA_SAMPLES];
uint agaa_nearestFragment[AGAA_SAMPLES];

// Makes the fragment the nearest of the samples where its depth is lowest. With isDecided, removes the samples from its
// mask that show another fragment. Loops are over covered samples, not over pairs of fragments, because software
// rasterisers of Mesa end all loops of an invocation after 65535 iterations in total.
void agaa_resolveFragment(uint fragment, uint record, bool isDecided) {
    uvec4 mask = agaa_maskOf(record);
    agaa_DepthPlane plane = agaa_keptPlane(record);
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word) {
        uint left = mask[word];
        while (left != 0u) {
            uint bit = left & (~left + 1u);
            uint i = word * 32u + uint(findLSB(left));
            vec2 at = agaa_coveragePosition(i, AGAA_SAMPLES);
            float depth = agaa_depthAt(plane, at);
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

// Reduces the mask of each fragment to the samples that show it. Of equal depths the first of the list shows.
// Returns the first fragment.
uint agaa_resolveList(uvec2 pixel) {
    uint head = agaa_sortList(pixel);
    agaa_keepPlanes(pixel, head);
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        agaa_nearestFragment[i] = 0u;
    for (uint pass = 0u; pass < 2u; ++pass) {
        uint fragment = head;
        while (fragment != 0u) {
            uint record = agaa_record(fragment);
            agaa_resolveFragment(fragment, record, pass == 1u);
            fragment = agaa_nextOf(record);
        }
    }
    return head;
}
#endif
