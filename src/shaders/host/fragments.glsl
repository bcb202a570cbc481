// Fragments pass: appends the coverage of each fragment, with the id of its primitive or its material, to the list of
// its pixel. Needs AGAA_STORAGE_IMAGES, AGAA_NEEDS_MATERIAL, AGAA_HAS_BATCHES and AGAA_DRAW_ORDER.
// Source: Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, section 3.1.
#if !defined(AGAA_STORAGE_IMAGES) || !defined(AGAA_NEEDS_MATERIAL) || !defined(AGAA_HAS_BATCHES) || \
    !defined(AGAA_DRAW_ORDER)
#error "fragments.glsl needs AGAA_STORAGE_IMAGES, AGAA_NEEDS_MATERIAL, AGAA_HAS_BATCHES and AGAA_DRAW_ORDER."
#endif
#include "host/fragment_depth.glsl"

#if AGAA_STORAGE_IMAGES
layout(r32ui, AGAA_BINDING_FRAGMENTS) uniform uimageBuffer agaa_fragments;
uint agaa_readFragments(uint word) { return imageLoad(agaa_fragments, int(word)).x; }
uint agaa_addToFragments(uint word, uint amount) { return imageAtomicAdd(agaa_fragments, int(word), amount); }
uint agaa_exchangeFragments(uint word, uint value) { return imageAtomicExchange(agaa_fragments, int(word), value); }
uint agaa_lowerFragments(uint word, uint value) { return imageAtomicMin(agaa_fragments, int(word), value); }
void agaa_setFragments(uint word, uint value) { imageStore(agaa_fragments, int(word), uvec4(value)); }
#else
layout(std430, AGAA_BINDING_FRAGMENTS) buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;
uint agaa_readFragments(uint word) { return agaa_fragments.words[word]; }
uint agaa_addToFragments(uint word, uint amount) { return atomicAdd(agaa_fragments.words[word], amount); }
uint agaa_exchangeFragments(uint word, uint value) { return atomicExchange(agaa_fragments.words[word], value); }
uint agaa_lowerFragments(uint word, uint value) { return atomicMin(agaa_fragments.words[word], value); }
void agaa_setFragments(uint word, uint value) { agaa_fragments.words[word] = value; }
#endif
#include "coverage/fragment_layout.glsl"

void agaa_loseFragment() {
    agaa_addToFragments(AGAA_LIST_LOST, 1u);
    agaa_countFragment(AGAA_COUNT_LOST_FRAGMENTS, 1u);
}

#if AGAA_HAS_BATCHES
// Inserts a depth into the sorted least depths of a pixel in a limited tile. Each word takes the lesser of its value
// and the one at hand, and the greater goes on to the next word, so that the result does not depend on the order of
// calls.
void agaa_insertDepth(uvec2 pixel, uint depth) {
    uint nearest = agaa_readFragments(AGAA_LIST_NEAREST);
    uint depths = agaa_depthsOf(pixel, agaa_frame.size, agaa_readFragments(AGAA_LIST_LIMITED), nearest);
    for (uint i = 0u; i <= nearest && depth != ~0u; ++i)
        depth = max(depth, agaa_lowerFragments(depths + i, depth));
}

// Returns whether this draw, which is not the first one, keeps a fragment.
bool agaa_isInBatch(uvec2 pixel, uint batch, agaa_DepthPlane plane, uvec4 mask) {
    uint batchOfTile = agaa_readFragments(agaa_tileOf(pixel, agaa_frame.size));
    uint limiting = agaa_readFragments(AGAA_LIST_LIMITING);
    bool isLimited = limiting != 0u && batchOfTile == limiting + 1u;
    if (isLimited && batch == limiting)
        agaa_insertDepth(pixel, agaa_depthOrder(plane, mask));
    if (batch != batchOfTile)
        return false;
    bool isFar = isLimited && agaa_depthOrder(plane, mask) >= ~agaa_readFragments(agaa_limitOf(pixel, agaa_frame.size));
    if (isFar)
        agaa_loseFragment();
    return !isFar;
}
#endif

void agaa_emit(AgaaSurfaceInput s) {
    uvec4 mask = agaa_coverageOf(s);
    if (agaa_coverageCount(mask) == 0u || AGAA_HELPER)
        return;
    uvec2 pixel = agaa_hostPixel();
    uvec2 size = agaa_frame.size;
    bool isFirstDraw = true;
    agaa_DepthPlane plane = agaa_cornerPlane();
#if AGAA_NEEDS_MATERIAL
    if (!agaa_packFragment(s, mask, plane))
        return;
#endif
#if AGAA_HAS_BATCHES
    uint batch = agaa_readFragments(AGAA_LIST_BATCH);
    isFirstDraw = batch == 0u;
    if (isFirstDraw)
        agaa_addToFragments(agaa_tileOf(pixel, size), 1u);
    else if (!agaa_isInBatch(pixel, batch, plane, mask))
        return;
#endif
    uint index = agaa_addToFragments(AGAA_LIST_COUNT, 1u);
    uint id = agaa_orderOfInput(s);
    if (isFirstDraw)
        agaa_countFragment(AGAA_COUNT_FRAGMENTS, 1u);
#if AGAA_NEEDS_MATERIAL
    if (isFirstDraw)
        agaa_countSurface(agaa_wasSanitised);
#else
    if (isFirstDraw)
        agaa_countMask(s);
#endif
    if (index >= agaa_fragmentCapacity()) {
        // If the scene is drawn again, a further draw has room.
        if (AGAA_HAS_BATCHES == 0 || !isFirstDraw)
            agaa_loseFragment();
        return;
    }
    uint base = agaa_recordOf(index + 1u, size, AGAA_HAS_BATCHES == 1);
    uint next = agaa_exchangeFragments(agaa_headOf(pixel, size), index + 1u);
    agaa_setFragments(base, id);
    agaa_setFragments(base + AGAA_FRAGMENT_NEXT_AT, next);
    agaa_setFragments(base + AGAA_FRAGMENT_DEPTH_AT, AGAA_DRAW_ORDER == 1 ? 0u : agaa_depthOrder(plane, mask));
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        agaa_setFragments(base + AGAA_FRAGMENT_MASK_AT + word, mask[word]);
#if AGAA_NEEDS_MATERIAL
    for (uint word = 0u; word < AGAA_MATERIAL_PAYLOAD_WORDS; ++word)
        agaa_setFragments(base + AGAA_FRAGMENT_MASK_AT + AGAA_SAMPLES / 32u + word, agaa_payload[word]);
#endif
}
