// The buffer of passes that expand triangles: counts, the sums of draws, then a list of large triangles. Needs
// AGAA_BINDING_TRIANGLES.
#ifndef AGAA_TRIANGLE_WORDS_GLSL
#define AGAA_TRIANGLE_WORDS_GLSL
#ifndef AGAA_BINDING_TRIANGLES
#error "triangle_words.glsl needs AGAA_BINDING_TRIANGLES."
#endif
#include "tables/layouts.inc"

layout(std430, AGAA_BINDING_TRIANGLES) buffer agaa_TriangleBlock {
    uint words[];
} agaa_triangles;

// Returns the index of the first word of an entry in the list of large triangles.
uint agaa_largeAt(uint entry) { return agaa_triangles.words[AGAA_LARGE_AT] + AGAA_LARGE_WORDS * entry; }

// Returns a dispatch of groups in rows of AGAA_GROUPS_PER_ROW.
uvec3 agaa_groupsInRows(uint groups) {
    return uvec3(min(groups, AGAA_GROUPS_PER_ROW), (groups + AGAA_GROUPS_PER_ROW - 1u) / AGAA_GROUPS_PER_ROW, 1u);
}

// Returns the number of the workgroup in such a dispatch.
uint agaa_groupInRows() { return gl_WorkGroupID.y * AGAA_GROUPS_PER_ROW + gl_WorkGroupID.x; }

// Returns the first of `count` ascending sums that is greater than the value; count if there is none. The sums are
// `stride` words apart.
uint agaa_firstSumAbove(uint value, uint first, uint count, uint stride) {
    uint low = 0u, high = count;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (agaa_triangles.words[first + stride * middle] > value)
            high = middle;
        else
            low = middle + 1u;
    }
    return low;
}
#endif
