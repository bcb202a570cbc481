// Appends fragments to the lists of their pixels (coverage/fragment_layout.glsl). The includer defines the functions
// that access words of the lists, agaa_listCapacity() and agaa_countFragment(counter, amount). Needs
// AGAA_HAS_BATCHES, AGAA_DRAW_ORDER, AGAA_HAS_DEPTH_PREPASS and common/frame.glsl.
// Source: Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, section 3.1.
#ifndef AGAA_APPEND_FRAGMENT_GLSL
#define AGAA_APPEND_FRAGMENT_GLSL
#if !defined(AGAA_HAS_BATCHES) || !defined(AGAA_DRAW_ORDER) || !defined(AGAA_HAS_DEPTH_PREPASS) || \
    !defined(AGAA_FRAME_GLSL)
#error "append_fragment.glsl needs AGAA_HAS_BATCHES, AGAA_DRAW_ORDER, AGAA_HAS_DEPTH_PREPASS and frame.glsl."
#endif
#include "coverage/fragment_layout.glsl"
#include "coverage/depth_order.glsl"

void agaa_loseFragment() {
    agaa_addToFragments(AGAA_LIST_LOST, 1u);
    agaa_countFragment(AGAA_COUNT_LOST_FRAGMENTS, 1u);
}

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

// Returns whether the draw is the first one of the frame, which counts all fragments.
bool agaa_isFirstDraw() { return AGAA_HAS_BATCHES == 0 || agaa_readFragments(AGAA_LIST_BATCH) == 0u; }

// Depths increase away from the eye. Lists widen the range of depths by up to 1.2 times the plane's change across the
// pixel, and fetched positions may be rounded in another way than those of the host's shaders.
bool agaa_isBehind(agaa_DepthPlane growing, uint bound) {
    float slack = abs(growing.range.x) * 9.5367e-7; // 2^-20, as in agaa_mergeRules()
    float nearest = growing.range.x - 1.25 * (abs(growing.slope.x) + abs(growing.slope.y)) - slack;
    return agaa_orderedBits(nearest) > ~bound;
}

#if AGAA_HAS_DEPTH_PREPASS
// Returns whether the fragment is behind the depth bound of the prepass, which no fragment changes.
bool agaa_isBehindPrepass(uvec2 pixel, agaa_DepthPlane plane) {
    return agaa_isBehind(agaa_growingDepth(plane), agaa_readFragments(agaa_boundOf(pixel, agaa_frame.size)));
}
#elif AGAA_DRAW_ORDER == 0
// Returns whether a fragment that covers its pixel hides this one. If this one covers the pixel, it hides what is
// behind it from now on. Which hidden fragments are kept depends on the order of calls; passes that merge fragments
// remove the others by the final bound (coverage/hidden_fragments.glsl).
bool agaa_isHidden(uvec2 pixel, agaa_DepthPlane plane, uvec4 mask) {
    agaa_DepthPlane growing = agaa_growingDepth(plane);
    uint word = agaa_boundOf(pixel, agaa_frame.size);
    if (agaa_coverageCount(mask) == AGAA_SAMPLES)
        agaa_raiseFragments(word, ~agaa_orderedBits(growing.range.y));
    return agaa_isBehind(growing, agaa_readFragments(word));
}
#endif

// Returns the record of the fragment, or 0 if the lists do not keep it.
uint agaa_appendFragment(uvec2 pixel, uint id, uvec4 mask, agaa_DepthPlane plane) {
    const uvec2 size = agaa_frame.size;
    bool isFirstDraw = true;
#if AGAA_HAS_DEPTH_PREPASS
    if (agaa_isBehindPrepass(pixel, plane))
        return 0u;
#endif
#if AGAA_HAS_BATCHES
    uint batch = agaa_readFragments(AGAA_LIST_BATCH);
    isFirstDraw = batch == 0u;
    if (isFirstDraw)
        agaa_addToFragments(agaa_tileOf(pixel, size), 1u);
    else if (!agaa_isInBatch(pixel, batch, plane, mask))
        return 0u;
#endif
    if (isFirstDraw)
        agaa_countFragment(AGAA_COUNT_FRAGMENTS, 1u);
#if AGAA_DRAW_ORDER == 0 && !AGAA_HAS_DEPTH_PREPASS
    if (agaa_isHidden(pixel, plane, mask))
        return 0u;
#endif
    uint index = agaa_addToFragments(AGAA_LIST_COUNT, 1u);
    if (index >= agaa_listCapacity()) {
        // If the scene is drawn again, a further draw has room.
        if (AGAA_HAS_BATCHES == 0 || !isFirstDraw)
            agaa_loseFragment();
        return 0u;
    }
    uint record = agaa_recordOf(index + 1u, size, AGAA_HAS_BATCHES == 1);
    uint next = agaa_exchangeFragments(agaa_headOf(pixel, size), index + 1u);
    agaa_setFragments(record, id);
    agaa_setFragments(record + AGAA_FRAGMENT_NEXT_AT, next);
    agaa_setFragments(record + AGAA_FRAGMENT_DEPTH_AT, AGAA_DRAW_ORDER == 1 ? 0u : agaa_depthOrder(plane, mask));
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        agaa_setFragments(record + AGAA_FRAGMENT_MASK_AT + word, mask[word]);
    return record;
}
#endif
