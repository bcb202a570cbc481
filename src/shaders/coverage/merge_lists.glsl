// Merges the fragments of each pixel, from front to back, into surfaces in memory. The includer defines
// bool agaa_readFragment(uvec2 pixel, uint record, out agaa_CoveredSurface s, out agaa_Stored material,
// out agaa_NormalSpread spread), which returns false for fragments at the far plane, and agaa_listedRange()
// (coverage/hidden_fragments.glsl). Needs AGAA_BINDING_SURFACES, common/counters.glsl,
// coverage/list_order.glsl and what coverage/pixel_order.glsl needs.
#if !defined(AGAA_BINDING_SURFACES) || !defined(AGAA_COUNTERS_GLSL) || !defined(AGAA_LIST_ORDER_GLSL)
#error "merge_lists.glsl needs AGAA_BINDING_SURFACES, counters.glsl and list_order.glsl."
#endif
layout(std430, AGAA_BINDING_SURFACES) buffer agaa_SurfaceBlock {
    uint words[];
} agaa_surfaces;
uint agaa_readSurfaces(uint word) { return agaa_surfaces.words[word]; }
void agaa_setSurfaces(uint word, uint value) { agaa_surfaces.words[word] = value; }
#include "coverage/merged_surfaces.glsl"
#include "coverage/listed_tiles.glsl"
#include "coverage/hidden_fragments.glsl"
#include "coverage/pixel_order.glsl"

// Returns the first fragment of the pixel's sorted list of those that are merged. In the order of draws
// (AGAA_COVERAGE_DRAW_ORDER) these are all fragments, as in the paper.
uint agaa_mergedList(uvec2 pixel) {
    uint head = agaa_sortList(pixel);
    if (head != 0u && agaa_fragments.words[agaa_record(head) + AGAA_FRAGMENT_DEPTH_AT] != 0u)
        agaa_unlinkCovered(pixel, head);
    return head;
}

void agaa_mergePixel(uvec2 pixel) {
    agaa_keptCount = 0u;
    if (AGAA_STREAMS != 0u)
        agaa_beginStream(pixel);
    uint fragment = agaa_mergedList(pixel);
    while (fragment != 0u) {
        uint record = agaa_record(fragment);
        agaa_CoveredSurface s;
        agaa_Stored material;
        agaa_NormalSpread spread;
        if (agaa_readFragment(pixel, record, s, material, spread))
            agaa_insertFragment(pixel, s, material, spread);
        fragment = agaa_nextOf(record);
    }
    for (uint a = 0u; a < agaa_aggregateLimit(); ++a) {
        uint base = agaa_surfaceBase(pixel, a);
        if (a < agaa_keptCount)
            agaa_storeKept(base, a);
        for (uint word = 0u; word < AGAA_MASK_WORDS && a >= agaa_keptCount; ++word)
            agaa_setSurfaces(base + word, 0u);
    }
    if (AGAA_NORMALISES != 0u)
        agaa_setSurfaces(agaa_boundOfSurfaces(pixel), agaa_fragments.words[agaa_boundOf(pixel, agaa_frame.size)]);
}

void main() {
    agaa_countBegin();
    agaa_countDraw();
    bool isListed = agaa_isTileListed();
    agaa_orderPixels(isListed);
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    barrier(); // surfaces may take the memory of the order
    bool isInside = all(lessThan(pixel, agaa_frame.size));
    if (isInside && isListed)
        agaa_mergePixel(pixel);
    else if (isInside)
        agaa_awaitDraw(pixel);
    agaa_countEnd();
}
