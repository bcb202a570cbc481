// Layout of the buffer of fragment lists: counts, the first fragment of each pixel, a word for each tile of 8 by 8
// pixels if the scene may be drawn again, then the fragments. Needs AGAA_SAMPLES, which common/constants.glsl has.
// Includers that read or write fragments define AGAA_PAYLOAD_WORDS, which is 0 by default.
//
// A fragment has the id of its primitive, the next fragment of its pixel, its depth, its coverage, and
// AGAA_PAYLOAD_WORDS further words. Fragments are numbered from 1. The number 0 ends a list. The depth is that at the
// centroid of the covered samples, as agaa_orderedBits() of a depth that increases away from the eye; it is 0 for all
// fragments if the draws decide the order.
//
// Batches: the first draw of the scene counts the fragments of each tile. If all of them have room, it is the only
// draw. Otherwise the tiles are divided among further draws, each of which keeps the fragments of its tiles only.
#ifndef AGAA_FRAGMENT_LAYOUT_GLSL
#define AGAA_FRAGMENT_LAYOUT_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && !defined(AGAA_SAMPLES)
#error "fragment_layout.glsl needs AGAA_SAMPLES."
#endif
#include "tables/layouts.inc"

#ifndef AGAA_PAYLOAD_WORDS
#define AGAA_PAYLOAD_WORDS 0u // of a fragment, written after the draw of the scene
#endif
#define AGAA_PAYLOAD_AT (AGAA_FRAGMENT_MASK_AT + AGAA_SAMPLES / 32u)
#define AGAA_FRAGMENT_WORDS (AGAA_FRAGMENT_MASK_AT + AGAA_SAMPLES / 32u + AGAA_PAYLOAD_WORDS)

uint agaa_headOf(uvec2 pixel, uvec2 size) { return AGAA_LIST_HEADS + pixel.y * size.x + pixel.x; }

uvec2 agaa_tilesOf(uvec2 size) { return (size + 7u) / 8u; }

// Returns the index of a tile's word: the number of its fragments during the first draw, then the draw that keeps them.
uint agaa_tileOf(uvec2 pixel, uvec2 size) {
    return AGAA_LIST_HEADS + size.x * size.y + pixel.y / 8u * agaa_tilesOf(size).x + pixel.x / 8u;
}

uint agaa_recordOf(uint fragment, uvec2 size, bool hasBatches) {
    uvec2 tiles = hasBatches ? agaa_tilesOf(size) : uvec2(0u);
    return AGAA_LIST_HEADS + size.x * size.y + tiles.x * tiles.y + (fragment - 1u) * AGAA_FRAGMENT_WORDS;
}
#endif
