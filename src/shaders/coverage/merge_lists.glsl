// Merges the fragments of each pixel, from front to back, into surfaces in memory. The includer defines
// bool agaa_readFragment(uvec2 pixel, uint record, out agaa_CoveredSurface s, out agaa_Stored material,
// out agaa_NormalSpread spread), which returns false for fragments at the far plane. Needs AGAA_BINDING_SURFACES,
// common/counters.glsl and coverage/list_order.glsl.
#if !defined(AGAA_BINDING_SURFACES) || !defined(AGAA_COUNTERS_GLSL) || !defined(AGAA_LIST_ORDER_GLSL)
#error "merge_lists.glsl needs AGAA_BINDING_SURFACES, counters.glsl and list_order.glsl."
#endif
layout(std430, AGAA_BINDING_SURFACES) buffer agaa_SurfaceBlock {
    uint words[];
} agaa_surfaces;
uint agaa_readSurfaces(uint word) { return agaa_surfaces.words[word]; }
void agaa_setSurfaces(uint word, uint value) { agaa_surfaces.words[word] = value; }
#include "coverage/merged_surfaces.glsl"

void agaa_mergePixel(uvec2 pixel) {
    agaa_keptCount = 0u;
    uint fragment = agaa_sortList(pixel);
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
}

// Returns whether this draw kept all fragments of the group's tile.
bool agaa_isTileInBatch() {
    if (!agaa_hasBatches())
        return true;
    uint batch = agaa_fragments.words[AGAA_LIST_BATCH];
    if (agaa_fragments.words[AGAA_LIST_BATCHES] == 1u)
        return batch == 0u;
    return batch != 0u && agaa_fragments.words[agaa_tileOf(gl_WorkGroupID.xy * 8u, agaa_frame.size)] == batch;
}

// Returns whether this draw has tiles to keep.
bool agaa_isDrawNeeded() {
    uint batch = agaa_fragments.words[AGAA_LIST_BATCH];
    return batch == 0u || batch < agaa_fragments.words[AGAA_LIST_BATCHES];
}

void main() {
    agaa_countBegin();
    if (gl_WorkGroupID.xy == uvec2(0u) && gl_LocalInvocationIndex == 0u && agaa_isDrawNeeded())
        agaa_count(AGAA_COUNT_BATCHES, 1u);
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool isInside = all(lessThan(pixel, agaa_frame.size));
    bool isInBatch = agaa_isTileInBatch();
    if (isInside && isInBatch)
        agaa_mergePixel(pixel);
    else if (isInside && agaa_fragments.words[AGAA_LIST_BATCH] == 0u)
        agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size)] = 0u; // a further draw makes the list again
    agaa_countEnd();
}
