// Layout of the buffer of fragment lists: counts, the first fragment of each pixel, the depth bound of each pixel,
// words for each tile of 8 by 8 pixels and for each pixel if the scene may be drawn again, then the fragments. Needs
// AGAA_SAMPLES, which common/constants.glsl has.
// Includers that read or write fragments define AGAA_PAYLOAD_WORDS, which is 0 by default.
//
// A fragment has the id of its primitive, the next fragment of its pixel, its depth, its coverage, and
// AGAA_PAYLOAD_WORDS further words. Fragments are numbered from 1. The number 0 ends a list. The depth is that at the
// centroid of the covered samples, as agaa_orderedBits() of a depth that increases away from the eye; it is 0 for all
// fragments if the draws decide the order.
//
// Depth bound: a fragment that covers all samples of its pixel hides fragments behind all of its depths. The word is
// ~d, where d is agaa_orderedBits() of the least depth that is known to hide; it is 0 before the first such fragment.
// With a depth prepass, coverage/bound_depths.comp sets the word alone; pixels whose word is not 0 count as covered.
//
// Batches: the first draw of the scene counts the fragments of each tile. If all of them have room, it is the only
// draw. Otherwise the tiles are divided among further draws, each of which keeps the fragments of its tiles only.
//
// Limited tiles: tiles that too few draws are left for, and tiles whose fragments do not have room together, keep the
// nearest AGAA_LIST_NEAREST fragments of each pixel. They take three draws, of which the first only makes room. The
// second one, AGAA_LIST_LIMITING, keeps the least depths of each pixel in the room for fragments. The third one keeps
// the fragments that are nearer than the last of these, so that the result does not depend on the order of fragments.
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

// Returns the index of the word of a pixel's depth bound.
uint agaa_boundOf(uvec2 pixel, uvec2 size) { return agaa_headOf(pixel, size) + size.x * size.y; }

// Returns the index of the first word behind those that all pixels have.
uint agaa_pixelWordsEnd(uvec2 size) { return AGAA_LIST_HEADS + AGAA_LIST_PIXEL_WORDS * size.x * size.y; }

// Returns the index of a tile's word: the number of its fragments during the first draw, then the draw that keeps them.
uint agaa_tileOf(uvec2 pixel, uvec2 size) {
    return agaa_pixelWordsEnd(size) + pixel.y / 8u * agaa_tilesOf(size).x + pixel.x / 8u;
}

// Returns the index of a pixel's word, ~d if the draw after AGAA_LIST_LIMITING keeps the fragments of a depth below d.
uint agaa_limitOf(uvec2 pixel, uvec2 size) {
    uvec2 tiles = agaa_tilesOf(size);
    return agaa_pixelWordsEnd(size) + tiles.x * tiles.y + pixel.y * size.x + pixel.x;
}

uint agaa_recordOf(uint fragment, uvec2 size, bool hasBatches) {
    uvec2 tiles = agaa_tilesOf(size);
    uint forBatches = hasBatches ? tiles.x * tiles.y + size.x * size.y : 0u;
    return agaa_pixelWordsEnd(size) + forBatches + (fragment - 1u) * AGAA_FRAGMENT_WORDS;
}

// Returns the index of the first of nearest + 1 words, the least depths of a pixel of a limited tile, in ascending
// order.
// limited   AGAA_LIST_LIMITED.
uint agaa_depthsOf(uvec2 pixel, uvec2 size, uint limited, uint nearest) {
    return agaa_recordOf(1u, size, true) + (pixel.y * size.x + pixel.x - limited) * (nearest + 1u);
}
#endif
