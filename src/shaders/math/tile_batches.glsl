// Division of consecutive tiles into batches whose fragments have room in one buffer.
#ifndef AGAA_MATH_TILE_BATCHES_GLSL
#define AGAA_MATH_TILE_BATCHES_GLSL
#include "real.glsl"

// The batch of the last tile.
struct agaa_TileBatch {
    uint number;    // from 1
    uint fragments; // in its tiles
};

// Returns the sum, or the largest uint if the sum is larger.
uint agaa_saturatingSum(uint a, uint b) { return a + min(b, ~a); }

bool agaa_batchHasRoom(agaa_TileBatch b, uint fragments, uint capacity) {
    return b.fragments <= capacity && fragments <= capacity - b.fragments;
}

// Returns the batch of the next tile: the same batch if it has room, otherwise a new one. No division of the tiles in
// this order has fewer batches. A tile with more fragments than the capacity has a batch of its own.
agaa_TileBatch agaa_batchOfNextTile(agaa_TileBatch b, uint fragments, uint capacity) {
    if (fragments == 0u || b.fragments == 0u || agaa_batchHasRoom(b, fragments, capacity))
        b.fragments += fragments;
    else
        b = agaa_TileBatch(b.number + 1u, fragments);
    return b;
}

#endif
