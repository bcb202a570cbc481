// The pixels of a list, one per lane. Needs common/frame.glsl.
#ifndef AGAA_LISTED_PIXELS_GLSL
#define AGAA_LISTED_PIXELS_GLSL
#include "adaptive/stored_choice.glsl"
#include "tables/layouts.inc"

uint agaa_listIndexOf(uint lane) {
    return (gl_WorkGroupID.y * AGAA_GROUPS_PER_ROW + gl_WorkGroupID.x) * AGAA_ITEMS_PER_GROUP + lane;
}

// Returns the pixel whose index is in this word; a pixel outside the image for lanes beyond the end of the list.
// length   Index of the word with the list's length.
uvec2 agaa_pixelAt(uint lane, uint word, uint length) {
    uint index = agaa_choices.words[word];
    return agaa_listIndexOf(lane) < agaa_choices.words[length]
               ? uvec2(index % agaa_frame.size.x, index / agaa_frame.size.x)
               : agaa_frame.size;
}

// The index is in range for lanes beyond the end of the list, too.
uint agaa_boundedListIndexOf(uint lane) { return min(agaa_listIndexOf(lane), agaa_pixelCount() - 1u); }

// A word of a sorted pixel has the number of its samples and its rank among the pixels of this number.
uint agaa_countOfRank(uint word) { return word >> AGAA_RANK_BITS; }
uint agaa_rankOf(uint word) { return word & ((1u << AGAA_RANK_BITS) - 1u); }
#endif
