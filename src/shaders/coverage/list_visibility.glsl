// Visibility of the fragments of a list: their depths are compared at each sample. The includer defines
// agaa_keepPlanes(pixel, head), which is called before planes are read, and agaa_listedPlane(record), whose result does
// not depend on samples that other fragments hide. Needs coverage/list_order.glsl, and with AGAA_SAMPLE_LANES
// AGAA_VISIBILITY_WORDS words of each lane (aggregate/lane_words.glsl).
#ifndef AGAA_LIST_VISIBILITY_GLSL
#define AGAA_LIST_VISIBILITY_GLSL
#ifndef AGAA_LIST_ORDER_GLSL
#error "list_visibility.glsl needs list_order.glsl."
#endif
#include "math/coverage_pattern.glsl"

// The nearest depth at each sample of the current pixel, and its fragment.
#if AGAA_SAMPLE_LANES
#include "aggregate/lane_words.glsl"
// GPUs keep arrays of a lane in device memory. Words of shared memory hold some of the samples, and the list is
// processed once for each part of the samples. A lane uses its own words only.
const uint agaa_samplesAtOnce = AGAA_VISIBILITY_WORDS / 2u;
float agaa_nearestDepth(uint i) { return uintBitsToFloat(AGAA_LANE_WORD(gl_LocalInvocationIndex, 2u * i)); }
uint agaa_nearestFragment(uint i) { return AGAA_LANE_WORD(gl_LocalInvocationIndex, 2u * i + 1u); }
void agaa_setNearest(uint i, float depth, uint fragment) {
    AGAA_LANE_WORD(gl_LocalInvocationIndex, 2u * i) = floatBitsToUint(depth);
    AGAA_LANE_WORD(gl_LocalInvocationIndex, 2u * i + 1u) = fragment;
}
#else
const uint agaa_samplesAtOnce = AGAA_SAMPLES;
float agaa_nearestDepths[AGAA_SAMPLES];
uint agaa_nearestFragments[AGAA_SAMPLES];
float agaa_nearestDepth(uint i) { return agaa_nearestDepths[i]; }
uint agaa_nearestFragment(uint i) { return agaa_nearestFragments[i]; }
void agaa_setNearest(uint i, float depth, uint fragment) {
    agaa_nearestDepths[i] = depth;
    agaa_nearestFragments[i] = fragment;
}
#endif

// Makes the fragment the nearest of the samples in `mask` where its depth is lowest. With isDecided, returns the
// samples that show it. Loops are over covered samples, not over pairs of fragments, because software rasterisers of
// Mesa end all loops of an invocation after 65535 iterations in total.
// base   The sample of bit 0.
// first  The first sample of which nearest depths are kept.
uint agaa_resolveSamples(uint fragment, agaa_DepthPlane plane, uint mask, uint base, uint first, bool isDecided) {
    uint shown = 0u;
    for (uint left = mask; left != 0u;) {
        uint bit = left & (~left + 1u);
        uint i = base + uint(findLSB(left));
        float depth = agaa_depthAt(plane, agaa_coveragePosition(i, AGAA_SAMPLES));
        uint other = agaa_nearestFragment(i - first);
        if (isDecided)
            shown |= other == fragment ? bit : 0u;
        else if (other == 0u || depth < agaa_nearestDepth(i - first))
            agaa_setNearest(i - first, depth, fragment);
        left ^= bit;
    }
    return shown;
}

// Resolves the contested samples of a fragment from sample `first` on. With isDecided, removes the samples from its
// mask that show another fragment.
void agaa_resolveFragment(uint fragment, uint record, uvec4 contested, uint first, bool isDecided) {
    agaa_DepthPlane plane = agaa_listedPlane(record);
    const uint words = (agaa_samplesAtOnce + 31u) / 32u;
    for (uint word = first / 32u; word < first / 32u + words; ++word) {
        const uint at = record + AGAA_FRAGMENT_MASK_AT + word;
        const uint mask = agaa_fragments.words[at];
        uint samples = contested[word];
        if (agaa_samplesAtOnce < 32u)
            samples &= (1u << (agaa_samplesAtOnce & 31u)) - 1u << (first & 31u);
        uint shown = agaa_resolveSamples(fragment, plane, mask & samples, 32u * word, first, isDecided);
        if (isDecided)
            agaa_fragments.words[at] = mask & ~samples | shown;
    }
}

// Removes samples from the mask of each fragment of a sorted list that fragments before it hide, because none of their
// depths is greater than any of its. Returns the samples that more than one fragment still has.
uvec4 agaa_hideByOrder(uint head) {
    uvec4 covered = uvec4(0u), contested = uvec4(0u);
    float farthest = -3e38; // depth of the fragments that cover
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        vec2 range = agaa_listedPlane(record).range;
        bool isBehind = range.x >= farthest; // of equal depths the first of the list shows
        if (isBehind) {
            mask &= ~covered;
            agaa_setMask(record, mask);
        }
        contested |= mask & covered;
        covered |= mask;
        farthest = mask == uvec4(0u) ? farthest : max(farthest, range.y);
        fragment = agaa_nextOf(record);
    }
    return contested;
}

// Removes fragments without samples from a list. Returns its first fragment.
uint agaa_unlinkHidden(uint head) {
    uint first = 0u;
    uint last = 0u; // the record of the last fragment that stays
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        if (agaa_coverageCount(agaa_maskOf(record)) != 0u) {
            if (last == 0u)
                first = fragment;
            else
                agaa_setNext(last, fragment);
            last = record;
        }
        fragment = agaa_nextOf(record);
    }
    if (last != 0u)
        agaa_setNext(last, 0u);
    return first;
}

// Reduces the mask of each fragment to the samples that show it. Of equal depths the first of the list shows. Returns
// the first fragment of the list of those that show at a sample.
uint agaa_resolveList(uvec2 pixel) {
    uint head = agaa_sortList(pixel);
    agaa_keepPlanes(pixel, head);
    if (head == 0u || agaa_nextOf(agaa_record(head)) == 0u)
        return head; // a fragment alone shows at all its samples
    const uvec4 contested = agaa_hideByOrder(head);
    const uint end = contested == uvec4(0u) ? 0u : AGAA_SAMPLES;
    for (uint first = 0u; first < end; first += agaa_samplesAtOnce) {
        for (uint i = 0u; i < agaa_samplesAtOnce; ++i)
            agaa_setNearest(i, 0.0, 0u);
        for (uint pass = 0u; pass < 2u; ++pass) {
            uint fragment = head;
            while (fragment != 0u) {
                uint record = agaa_record(fragment);
                agaa_resolveFragment(fragment, record, contested, first, pass == 1u);
                fragment = agaa_nextOf(record);
            }
        }
    }
    return agaa_unlinkHidden(head);
}
#endif
