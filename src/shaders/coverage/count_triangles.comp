// Sums the triangles of the host's draws, so that a lane of a later pass finds its triangle.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "math/tile_batches.glsl"
#include "math/light.glsl"
#include "ids/fetch.glsl"
#include "coverage/triangle_words.glsl"
#if !AGAA_COVERS_TARGET
#include "coverage/fragment_words.glsl"
#endif

shared uint agaa_shareSums[64]; // of the draws of each lane

uint agaa_primitivesOf(uint draw) {
    uint primitives = agaa_drawOf(draw).primitives;
    if (primitives > AGAA_MAX_PRIMITIVES)
        agaa_count(AGAA_COUNT_UNANNOUNCED, primitives - AGAA_MAX_PRIMITIVES);
    return min(primitives, AGAA_MAX_PRIMITIVES);
}

void main() {
    agaa_countBegin();
    const uint lane = gl_LocalInvocationIndex;
    const uint share = (AGAA_MAX_DRAWS + 63u) / 64u;
    const uint begin = min(lane * share, AGAA_MAX_DRAWS), end = min(begin + share, AGAA_MAX_DRAWS);
    uint sum = 0u;
    for (uint draw = begin; draw < end; ++draw) {
        sum = agaa_saturatingSum(sum, agaa_primitivesOf(draw));
        agaa_triangles.words[AGAA_TRIANGLE_SUMS + draw] = sum;
    }
    agaa_shareSums[lane] = sum;
    barrier();
    uint before = 0u;
    for (uint k = 0u; k < lane; ++k)
        before = agaa_saturatingSum(before, agaa_shareSums[k]);
    for (uint draw = begin; draw < end; ++draw)
        agaa_triangles.words[AGAA_TRIANGLE_SUMS + draw] =
            agaa_saturatingSum(before, agaa_triangles.words[AGAA_TRIANGLE_SUMS + draw]);
    if (lane == 63u) {
        uint all = agaa_saturatingSum(before, sum);
        if (all > AGAA_MAX_TRIANGLES)
            agaa_count(AGAA_COUNT_UNANNOUNCED, all - AGAA_MAX_TRIANGLES);
        uint total = min(all, AGAA_MAX_TRIANGLES);
        agaa_triangles.words[AGAA_FINDS_DEPTHS] = 1u;
        agaa_triangles.words[AGAA_TRIANGLES_TOTAL] = total;
        agaa_triangles.words[AGAA_LARGE_COUNT] = 0u;
        agaa_triangles.words[AGAA_LARGE_AT] = AGAA_TRIANGLE_SUMS + AGAA_MAX_DRAWS;
        uvec3 groups = agaa_groupsInRows((total + 63u) / 64u);
        for (uint i = 0u; i < 3u; ++i)
#if AGAA_COVERS_TARGET
            agaa_triangles.words[AGAA_TRIANGLE_DISPATCH + i] = groups[i];
#else
            agaa_fragments.words[AGAA_LIST_TRIANGLE_GROUPS + i] = groups[i];
#endif
    }
    agaa_countEnd();
}
