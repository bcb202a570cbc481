// Tiles whose fragments the last draw of the scene has listed, in passes with a workgroup for each tile
// (coverage/fragment_layout.glsl). Needs common/counters.glsl and coverage/fragment_words.glsl.
#ifndef AGAA_LISTED_TILES_GLSL
#define AGAA_LISTED_TILES_GLSL
#if !defined(AGAA_COUNTERS_GLSL) || !defined(AGAA_FRAGMENT_WORDS_GLSL)
#error "listed_tiles.glsl needs counters.glsl and fragment_words.glsl."
#endif

// Returns whether the lists have the fragments of the group's tile.
bool agaa_isTileListed() {
    if (!agaa_hasBatches())
        return true;
    uint batch = agaa_fragments.words[AGAA_LIST_BATCH];
    if (agaa_fragments.words[AGAA_LIST_BATCHES] == 1u)
        return batch == 0u;
    return batch != 0u && agaa_fragments.words[agaa_tileOf(gl_WorkGroupID.xy * 8u, agaa_frame.size)] == batch;
}

void agaa_countDraw() {
    if (gl_WorkGroupID.xy == uvec2(0u) && gl_LocalInvocationIndex == 0u)
        agaa_count(AGAA_COUNT_BATCHES, 1u);
}

// Prepares a pixel whose tile is not listed for further draws.
void agaa_awaitDraw(uvec2 pixel) {
    const uvec2 size = agaa_frame.size;
    uint batch = agaa_fragments.words[AGAA_LIST_BATCH];
    if (batch == 0u)
        agaa_fragments.words[agaa_headOf(pixel, size)] = 0u; // the first draw may have listed some of the fragments
    uint limiting = agaa_fragments.words[AGAA_LIST_LIMITING];
    uint limited = agaa_fragments.words[AGAA_LIST_LIMITED];
    if (limiting == 0u || pixel.y * size.x + pixel.x < limited)
        return;
    uint nearest = agaa_fragments.words[AGAA_LIST_NEAREST];
    uint depths = agaa_depthsOf(pixel, size, limited, nearest);
    for (uint i = 0u; i <= nearest && batch + 1u == limiting; ++i)
        agaa_fragments.words[depths + i] = ~0u;
    if (batch == limiting)
        agaa_fragments.words[agaa_limitOf(pixel, size)] = ~agaa_fragments.words[depths + nearest];
}
#endif
