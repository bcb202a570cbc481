// Runs after the first draw of the scene. It decides whether all fragments had room and, if not, assigns tiles to
// further draws (coverage/fragment_layout.glsl).
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

shared uint agaa_sums[64];             // fragments in the tiles of each lane
shared agaa_TileBatch agaa_starts[64]; // the batch before the tiles of each lane
shared uint agaa_isAnyTooFull;         // 1: the fragments of a tile do not have room together
shared uint agaa_firstLimited;         // the first limited tile
shared uint agaa_lastNumber;           // the last draw with tiles that are not limited
shared bool agaa_isLimiting;           // tiles are limited

bool agaa_isTooFull(uint fragments) { return fragments > agaa_frame.fragmentCapacity; }

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
        for (uint t = lane * share; t < end; ++t) {
            uint fragments = agaa_fragments.words[first + t];
            if (!agaa_isTooFull(fragments))
                batch = agaa_batchOfNextTile(batch, fragments, capacity);
        }
    }
    return batch.number;
}

void agaa_limitTiles() {
    const uvec2 size = agaa_frame.size;
    uint limited = agaa_firstLimited / agaa_tilesOf(size).x * 8u * size.x;
    uint pixels = size.x * size.y - limited;
    agaa_fragments.words[AGAA_LIST_LIMITING] = agaa_lastNumber + 2u;
    agaa_fragments.words[AGAA_LIST_LIMITED] = limited;
    agaa_fragments.words[AGAA_LIST_NEAREST] = agaa_frame.fragmentCapacity / pixels; // the plan has room for 1
    agaa_fragments.words[AGAA_LIST_BATCHES] = agaa_lastNumber + 4u;
}

void main() {
    const uint lane = gl_LocalInvocationIndex;
    if (agaa_fragments.words[AGAA_LIST_BATCH] != 0u)
        return;
    if (lane == 0u) {
        agaa_isAnyTooFull = 0u;
        agaa_firstLimited = ~0u;
    }
    barrier();
    uvec2 tiles = agaa_tilesOf(agaa_frame.size);
    uint count = tiles.x * tiles.y;
    uint first = agaa_tileOf(uvec2(0u), agaa_frame.size);
    uint share = (count + 63u) / 64u;
    uint begin = min(lane * share, count), end = min(begin + share, count);
    uint sum = 0u;
    for (uint t = begin; t < end; ++t) {
        uint fragments = agaa_fragments.words[first + t];
        if (agaa_isTooFull(fragments))
            atomicMax(agaa_isAnyTooFull, 1u);
        sum = agaa_saturatingSum(sum, fragments);
    }
    agaa_sums[lane] = sum;
    barrier();
    uint all = 0u;
    for (uint k = 0u; k < 64u; ++k)
        all = agaa_saturatingSum(all, agaa_sums[k]);
    bool isEnough = all <= agaa_frame.fragmentCapacity;
    if (lane == 0u) {
        uint last = isEnough ? 0u : agaa_divideTiles(first, count, share);
        agaa_isLimiting = agaa_isAnyTooFull != 0u || last >= agaa_frame.maxBatches;
        agaa_lastNumber = agaa_isLimiting ? min(last, agaa_frame.maxBatches - 4u) : last;
        agaa_fragments.words[AGAA_LIST_BATCHES] = 1u + last;
        agaa_fragments.words[AGAA_LIST_FINISHED] = isEnough ? 1u : 0u;
        uvec3 groups = uvec3(tiles, 1u);
        for (uint i = 0u; i < 3u; ++i)
            agaa_fragments.words[AGAA_LIST_TILE_GROUPS + i] = groups[i];
    }
    barrier();
    agaa_TileBatch batch = agaa_starts[lane];
    for (uint t = begin; t < end; ++t) {
        uint fragments = agaa_fragments.words[first + t];
        bool isTooFull = agaa_isTooFull(fragments);
        if (!isTooFull)
            batch = agaa_batchOfNextTile(batch, fragments, agaa_frame.fragmentCapacity);
        bool isLimited = isTooFull || batch.number > agaa_lastNumber;
        if (isLimited && !isEnough)
            atomicMin(agaa_firstLimited, t);
        agaa_fragments.words[first + t] = isEnough ? 0u : isLimited ? agaa_lastNumber + 3u : batch.number;
    }
    barrier();
    if (lane == 0u && agaa_isLimiting)
        agaa_limitTiles();
}
