// Pixels that one pass defers to another: a bit each, two words a tile of 8 by 8. A group of the pass that takes them has
// a region of tiles, so that its lanes are full where tiles defer few pixels.
#ifndef AGAA_DEFERRED_PIXELS_GLSL
#define AGAA_DEFERRED_PIXELS_GLSL
#ifdef AGAA_CONSUMES_DEFERRED
#define AGAA_DEFERRED_ACCESS readonly
#else
#define AGAA_DEFERRED_ACCESS coherent
#endif
layout(std430, AGAA_BINDING_DEFERRED) AGAA_DEFERRED_ACCESS buffer agaa_DeferredBlock {
    uint words[];
} agaa_deferred;

uvec2 agaa_tileCounts() { return (agaa_frame.size + 7u) / 8u; }

uint agaa_deferredWord(uvec2 tile, uint lane) { return 2u * (tile.y * agaa_tileCounts().x + tile.x) + (lane >> 5u); }

#ifndef AGAA_CONSUMES_DEFERRED
shared uint agaa_deferredHere[2];

// Called by all lanes, which have a pixel of the tile each.
void agaa_deferPixel(uvec2 tile, bool isDeferred) {
    const uint lane = gl_LocalInvocationIndex;
    if (lane < 2u)
        agaa_deferredHere[lane] = 0u;
    barrier();
    if (isDeferred)
        atomicOr(agaa_deferredHere[lane >> 5u], 1u << (lane & 31u));
    barrier();
    if (lane < 2u && all(lessThan(tile, agaa_tileCounts())))
        agaa_deferred.words[agaa_deferredWord(tile, 32u * lane)] = agaa_deferredHere[lane];
}

// One more, after all tiles of the group were sorted.
void agaa_deferLate(uvec2 pixel) {
    uint lane = pixel.x & 7u | (pixel.y & 7u) << 3u;
    atomicOr(agaa_deferred.words[agaa_deferredWord(pixel / 8u, lane)], 1u << (lane & 31u));
}
#else
const uint agaa_maxDeferred = 64u * AGAA_REGION_SIDE * AGAA_REGION_SIDE;
shared uint agaa_deferredCount;
shared uint agaa_deferredPixels[agaa_maxDeferred]; // lane in its tile | tile << 6
uint agaa_firstDeferred = 0u; // place of the first pixel in hand; a lane has one each

// Called by all lanes; returns how many there are in the region.
uint agaa_findDeferred() {
    const uint lane = gl_LocalInvocationIndex;
    if (lane == 0u)
        agaa_deferredCount = 0u;
    barrier();
    for (uint t = 0u; t < AGAA_REGION_SIDE * AGAA_REGION_SIDE; ++t) {
        uvec2 tile = gl_WorkGroupID.xy * AGAA_REGION_SIDE + uvec2(t % AGAA_REGION_SIDE, t / AGAA_REGION_SIDE);
        if (any(greaterThanEqual(tile, agaa_tileCounts())))
            continue;
        if ((agaa_deferred.words[agaa_deferredWord(tile, lane)] >> (lane & 31u) & 1u) != 0u)
            agaa_deferredPixels[atomicAdd(agaa_deferredCount, 1u)] = lane | t << 6u;
    }
    barrier();
    return agaa_deferredCount;
}

// That a lane has in hand.
uvec2 agaa_pixelOf(uint lane) {
    uint place = agaa_deferredPixels[min(agaa_firstDeferred + lane, agaa_maxDeferred - 1u)];
    uint tile = place >> 6u;
    uvec2 corner = gl_WorkGroupID.xy * AGAA_REGION_SIDE + uvec2(tile % AGAA_REGION_SIDE, tile / AGAA_REGION_SIDE);
    return corner * 8u + uvec2(place & 7u, place >> 3u & 7u);
}
#endif
#endif
