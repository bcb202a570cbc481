// Edges between pixels, a bit each, in words along rows and along columns. A region of 32 by 32 pixels has a word for
// each row and column, of its edges along it and of those that cross it. Needs common/frame.glsl.
#ifndef AGAA_EDGE_WORDS_GLSL
#define AGAA_EDGE_WORDS_GLSL
#include "tables/layouts.inc"

layout(std430, AGAA_BINDING_EDGES) AGAA_EDGES_ACCESS buffer agaa_EdgeBlock { uint words[]; } agaa_edges;

const uint agaa_rows = 0u;    // edges along rows are the upper edges of pixels
const uint agaa_columns = 1u; // edges along columns are the left edges of pixels

uint agaa_edgeWordAt(uvec2 region, uint direction, uint crossing, uint line) {
    uint regionsPerRow = (agaa_frame.size.x + 31u) / 32u;
    return (region.y * regionsPerRow + region.x) * AGAA_EDGE_REGION_WORDS + (2u * direction + crossing) * 32u +
           (line & 31u);
}

#if AGAA_READS_EDGES
// Returns the edges along or across 32 pixels of a row or column; 0 outside the image.
uint agaa_edgeWord(uint direction, uint crossing, int line, int word) {
    ivec2 region = direction == agaa_rows ? ivec2(word, line >> 5) : ivec2(line >> 5, word);
    ivec2 regions = (ivec2(agaa_frame.size) + 31) / 32;
    if (line < 0 || any(lessThan(region, ivec2(0))) || any(greaterThanEqual(region, regions)))
        return 0u;
    return agaa_edges.words[agaa_edgeWordAt(uvec2(region), direction, crossing, uint(line))];
}

bool agaa_hasEdge(uint direction, uint crossing, int line, int at) {
    return (agaa_edgeWord(direction, crossing, line, at >> 5) >> uint(at & 31) & 1u) != 0u;
}

bool agaa_hasUpperEdge(ivec2 pixel) { return agaa_hasEdge(agaa_rows, 0u, pixel.y, pixel.x); }
bool agaa_hasLeftEdge(ivec2 pixel) { return agaa_hasEdge(agaa_rows, 1u, pixel.y, pixel.x); }
#endif
#endif
