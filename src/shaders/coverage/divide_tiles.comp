// Runs after the first draw of the scene. It decides whether all fragments had room and, if not, assigns tiles to
// further draws.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "coverage/fragment_layout.glsl"
#include "math/tile_batches.glsl"

layout(std430, AGAA_BINDING_FRAGMENTS) buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;

shared uint agaa_sums[64];              // fragments in the tiles of each lane
shared agaa_TileBatch agaa_starts[64]; // the batch before the tiles of each lane

// Divides the tiles in their order and sets agaa_starts. Returns the last batch. share: tiles of a lane.
uint agaa_divideTiles(uint first, uint count, uint share) {
    const uint capacity = agaa_frame.fragmentCapacity;
    agaa_TileBatch batch = agaa_TileBatch(1u, 0u);
    for (uint lane = 0u; lane < 64u; ++lane) {
        agaa_starts[lane] = batch;
        if (agaa_batchHasRoom(batch, agaa_sums[lane], capacity)) { // so that one lane reads few tiles
            batch.fragments += agaa_sums[lane];
            continue;
        }
        uint end = min((lane + 1u) * share, count);
        for (uint t = lane * share; t < end; ++t)
            batch = agaa_batchOfNextTile(batch, agaa_fragments.words[first + t], capacity);
    }
    return batch.number;
}

void main() {
    const uint lane = gl_LocalInvocationIndex;
    if (agaa_fragments.words[AGAA_LIST_BATCH] != 0u)
        return;
    uvec2 tiles = agaa_tilesOf(agaa_frame.size);
    uint count = tiles.x * tiles.y;
    uint first = agaa_tileOf(uvec2(0u), agaa_frame.size);
    uint share = (count + 63u) / 64u;
    uint begin = min(lane * share, count), end = min(begin + share, count);
    uint sum = 0u;
    for (uint t = begin; t < end; ++t)
        sum = agaa_saturatingSum(sum, agaa_fragments.words[first + t]);
    agaa_sums[lane] = sum;
    barrier();
    uint all = 0u;
    for (uint k = 0u; k < 64u; ++k)
        all = agaa_saturatingSum(all, agaa_sums[k]);
    bool isEnough = all <= agaa_frame.fragmentCapacity;
    uint most = agaa_frame.maxBatches - 1u;
    if (lane == 0u) {
        uint last = isEnough ? 0u : min(agaa_divideTiles(first, count, share), most);
        agaa_fragments.words[AGAA_LIST_BATCHES] = 1u + last;
        agaa_fragments.words[AGAA_LIST_PREDICATE] = isEnough ? 0u : 1u;
    }
    barrier();
    agaa_TileBatch batch = agaa_starts[lane];
    for (uint t = begin; t < end; ++t) {
        batch = agaa_batchOfNextTile(batch, agaa_fragments.words[first + t], agaa_frame.fragmentCapacity);
        agaa_fragments.words[first + t] = isEnough ? 0u : min(batch.number, most);
    }
}
