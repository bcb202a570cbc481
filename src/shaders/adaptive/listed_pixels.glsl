// The pixels of a list, one a lane.
#ifndef AGAA_LISTED_PIXELS_GLSL
#define AGAA_LISTED_PIXELS_GLSL
#include "adaptive/stored_choice.glsl"

const uint agaa_groupsPerRow = 32768u;

uint agaa_listIndexOf(uint lane) { return (gl_WorkGroupID.y * agaa_groupsPerRow + gl_WorkGroupID.x) * 64u + lane; }

// The pixel whose index is in this word; where the list is shorter, one outside the image. length: where the list's is.
uvec2 agaa_pixelAt(uint lane, uint word, uint length) {
    uint index = agaa_choices.words[word];
    return agaa_listIndexOf(lane) < agaa_choices.words[length] ? uvec2(index % agaa_frame.size.x, index / agaa_frame.size.x)
                                                            : agaa_frame.size;
}

// A place in memory, also where the list is shorter.
uint agaa_boundedListIndexOf(uint lane) { return min(agaa_listIndexOf(lane), agaa_pixelCount() - 1u); }

// Of a word of sorted pixels: the number of samples, and the rank among the pixels of this number.
uint agaa_countOfRank(uint word) { return word >> AGAA_RANK_BITS; }
uint agaa_rankOf(uint word) { return word & ((1u << AGAA_RANK_BITS) - 1u); }
#endif
