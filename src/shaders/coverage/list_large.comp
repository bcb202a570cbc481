// Sums the blocks of the large triangles that the draw has found, so that a workgroup of the next pass finds its block.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#include "common/bindings.glsl"
#include "math/tile_batches.glsl"
#include "coverage/triangle_words.glsl"

shared uint agaa_shareSums[64]; // of the entries of each lane

void main() {
    const uint lane = gl_LocalInvocationIndex;
    const uint count = agaa_triangles.words[AGAA_LARGE_COUNT];
    const uint share = (count + 63u) / 64u;
    const uint begin = min(lane * share, count), end = min(begin + share, count);
    uint sum = 0u;
    for (uint entry = begin; entry < end; ++entry) {
        uint at = agaa_largeAt(entry) + 1u;
        sum = agaa_saturatingSum(sum, agaa_triangles.words[at]);
        agaa_triangles.words[at] = sum;
    }
    agaa_shareSums[lane] = sum;
    barrier();
    uint before = 0u;
    for (uint k = 0u; k < lane; ++k)
        before = agaa_saturatingSum(before, agaa_shareSums[k]);
    for (uint entry = begin; entry < end; ++entry) {
        uint at = agaa_largeAt(entry) + 1u;
        agaa_triangles.words[at] = agaa_saturatingSum(before, agaa_triangles.words[at]);
    }
    if (lane == 63u) {
        uvec3 groups = agaa_groupsInRows(agaa_saturatingSum(before, sum));
        for (uint i = 0u; i < 3u; ++i)
            agaa_triangles.words[AGAA_LARGE_DISPATCH + i] = groups[i];
        agaa_triangles.words[AGAA_LARGE_LISTED] = count;
        agaa_triangles.words[AGAA_LARGE_COUNT] = 0u; // for the next draw
    }
}
