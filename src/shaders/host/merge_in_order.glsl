// Fragments pass of devices that order the fragments of a pixel, by fragment shader interlock or, with AGAA_IN_TARGETS,
// by attachments that shaders read. Each fragment merges into the surfaces of its pixel, in the order of the draws and
// without lists (Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, section 3). Needs AGAA_IN_TARGETS and
// AGAA_MERGE_RULE.
#if !defined(AGAA_IN_TARGETS) || !defined(AGAA_MERGE_RULE)
#error "merge_in_order.glsl needs AGAA_IN_TARGETS and AGAA_MERGE_RULE."
#endif
#include "coverage/color_difference.glsl"
#include "host/fragment_coverage.glsl"

#if AGAA_IN_TARGETS == 0
layout(pixel_interlock_ordered) in;
#endif

#if AGAA_IN_TARGETS
uint agaa_readSurfaces(uint word) { return agaa_targetWords[word]; }
void agaa_setSurfaces(uint word, uint value) { agaa_targetWords[word] = value; }
#elif AGAA_STORAGE_IMAGES
layout(r32ui, AGAA_BINDING_SURFACES) coherent uniform uimageBuffer agaa_surfaces;
uint agaa_readSurfaces(uint word) { return imageLoad(agaa_surfaces, int(word)).x; }
void agaa_setSurfaces(uint word, uint value) { imageStore(agaa_surfaces, int(word), uvec4(value)); }
#else
layout(std430, AGAA_BINDING_SURFACES) coherent buffer agaa_SurfaceBlock {
    uint words[];
} agaa_surfaces;
uint agaa_readSurfaces(uint word) { return agaa_surfaces.words[word]; }
void agaa_setSurfaces(uint word, uint value) { agaa_surfaces.words[word] = value; }
#endif
#if AGAA_FRAME_CONSTANTS != AGAA_CONSTANTS_BLOCK
uint agaa_aggregateLimit() { return AGAA_AGGREGATES; }
#endif
void agaa_count(uint counter, uint amount) {
    if (amount != 0u)
        agaa_countFragment(counter, amount);
}
#include "coverage/merged_surfaces.glsl"

bool agaa_merges = false; // the current fragment covers a sample

// Does the work that needs no other fragments of the pixel, before the critical section.
void agaa_prepareMerge(AgaaSurfaceInput s) {
    uvec4 mask = agaa_coverageOf(s);
    if (agaa_coverageCount(mask) == 0u || AGAA_HELPER)
        return;
    agaa_merges = agaa_packFragment(s, mask, agaa_cornerPlane());
    agaa_count(AGAA_COUNT_FRAGMENTS, agaa_merges ? 1u : 0u);
    if (agaa_merges)
        agaa_countSurface(agaa_wasSanitised);
}

void agaa_loadSurfaces(uvec2 pixel) {
    agaa_keptCount = 0u;
    bool exists = true;
    for (uint a = 0u; a < agaa_aggregateLimit() && exists; ++a) {
        uint base = agaa_surfaceBase(pixel, a);
        uvec4 mask = uvec4(0u);
        for (uint word = 0u; word < AGAA_MASK_WORDS; ++word)
            mask[word] = agaa_readSurfaces(base + word);
        exists = agaa_coverageCount(mask) != 0u;
        if (exists) {
            agaa_keep(a, agaa_surfaceOfWords(mask, agaa_readSurfaces(base + AGAA_DEPTH_WORD),
                                             agaa_readSurfaces(base + AGAA_SLOPE_WORD),
                                             agaa_readSurfaces(base + AGAA_NORMAL_WORD)));
            agaa_keptCount = a + 1u;
        }
    }
}

// Merges the fragment, in the critical section.
void agaa_mergeInOrder() {
    if (!agaa_merges)
        return;
    uvec2 pixel = agaa_hostPixel();
    agaa_CoveredSurface s =
        agaa_surfaceOfWords(agaa_covered, agaa_payload[0], agaa_payload[1], agaa_payload[2]);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_packed[w] = agaa_payload[AGAA_PLANE_WORDS + AGAA_SPREAD_WORDS + w];
    agaa_Stored material = agaa_unpackSurface();
    agaa_NormalSpread spread = agaa_noSpread(s.normal);
#if AGAA_SPREAD_WORDS
    spread = agaa_unpackSpread(s.normal, uvec2(agaa_payload[AGAA_PLANE_WORDS], agaa_payload[AGAA_PLANE_WORDS + 1u]));
#endif
    agaa_loadSurfaces(pixel);
    agaa_Insertion done = agaa_insertFragment(pixel, s, material, spread);
    if (done.from != AGAA_NO_SURFACE && done.into != agaa_aggregateLimit())
        agaa_storeKept(agaa_surfaceBase(pixel, done.into), done.into);
    if (done.to != AGAA_NO_SURFACE)
        agaa_storeKept(agaa_surfaceBase(pixel, done.to), done.to);
}

#if AGAA_IN_TARGETS
void agaa_emit(AgaaSurfaceInput s) {
    agaa_prepareMerge(s);
    agaa_fetchTargets();
    agaa_mergeInOrder();
    agaa_storeTargets();
}
#else
// GLSL allows the critical section only in main(), outside of all branches.
#define agaa_emit(s) \
    agaa_prepareMerge(s); \
    beginInvocationInterlockARB(); \
    agaa_mergeInOrder(); \
    endInvocationInterlockARB()
#endif
