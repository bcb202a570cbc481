// Runs after the first draw of the scene. It decides whether all fragments had room and, if not, assigns tiles to
// further draws.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "coverage/fragment_layout.glsl"

layout(std430, AGAA_BINDING_FRAGMENTS) buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;

shared uint agaa_sums[64];    // fragments in the tiles of each lane
shared uint agaa_fullest[64]; // fragments in the fullest of them

void main() {
    const uint lane = gl_LocalInvocationIndex;
    if (agaa_fragments.words[AGAA_LIST_BATCH] != 0u)
        return;
    uvec2 tiles = agaa_tilesOf(agaa_frame.size);
    uint count = tiles.x * tiles.y;
    uint first = agaa_tileOf(uvec2(0u), agaa_frame.size);
    uint share = (count + 63u) / 64u; // tiles of a lane
    uint begin = min(lane * share, count), end = min(begin + share, count);
    uint sum = 0u, fullest = 0u;
    for (uint t = begin; t < end; ++t) {
        uint fragments = agaa_fragments.words[first + t];
        sum += fragments;
        fullest = max(fullest, fragments);
    }
    agaa_sums[lane] = sum;
    agaa_fullest[lane] = fullest;
    barrier();
    uint before = 0u, all = 0u;
    for (uint k = 0u; k < 64u; ++k) {
        before += k < lane ? agaa_sums[k] : 0u;
        all += agaa_sums[k];
        fullest = max(fullest, agaa_fullest[k]);
    }
    bool isEnough = all <= agaa_frame.fragmentCapacity;
    // Tiles whose first fragments are in the same interval of this length have room in one draw.
    uint interval = max(agaa_frame.fragmentCapacity, fullest + 1u) - fullest;
    uint most = agaa_frame.maxBatches - 1u;
    for (uint t = begin; t < end; ++t) {
        uint fragments = agaa_fragments.words[first + t];
        agaa_fragments.words[first + t] = isEnough ? 0u : min(1u + before / interval, most);
        before += fragments;
    }
    if (lane == 0u) {
        agaa_fragments.words[AGAA_LIST_BATCHES] = isEnough ? 1u : min(2u + all / interval, most + 1u);
        agaa_fragments.words[AGAA_LIST_PREDICATE] = isEnough ? 0u : 1u;
    }
}
