// The pixel of each lane: of a tile, or of all pixels by descending number of samples (Hollaender et al. 2013, section 4.2).
#ifndef AGAA_SORTED_PIXELS_GLSL
#define AGAA_SORTED_PIXELS_GLSL
#include "passes/adaptive_flags.glsl"
#include "passes/stored_choice.glsl"

// A group has 64 pixels in order.
uint agaa_placeOf(uint lane) { return (gl_WorkGroupID.y * 32768u + gl_WorkGroupID.x) * 64u + lane; }

uvec2 agaa_pixelOf(uint lane) {
    if (!agaa_isAdaptive(agaa_sorted))
        return gl_WorkGroupID.xy * 8u + uvec2(lane & 7u, lane >> 3u);
    uint place = agaa_placeOf(lane);
    uint index = agaa_choices.words[agaa_sortedAt(min(place, agaa_pixelCount() - 1u))];
    return place < agaa_pixelCount() ? uvec2(index % agaa_frame.size.x, index / agaa_frame.size.x) : agaa_frame.size.xy;
}

// Of a pixel's word, count and rank among the pixels of this count.
uint agaa_countOfRank(uint word) { return word >> AGAA_RANK_BITS; }
uint agaa_rankOf(uint word) { return word & ((1u << AGAA_RANK_BITS) - 1u); }

// Of this lane's pixel.
uint agaa_sortedCount() {
    uint place = agaa_placeOf(gl_LocalInvocationIndex);
    if (place >= agaa_pixelCount())
        return 0u;
    return agaa_countOfRank(agaa_choices.words[agaa_rankAt(agaa_choices.words[agaa_sortedAt(place)])]);
}
#endif
