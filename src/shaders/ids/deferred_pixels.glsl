// Bit mask of the pixels deferred to a later pass, two words per tile of 8 by 8 pixels. A workgroup of the consuming
// pass has a region of tiles, so that its lanes are busy where tiles defer few pixels. Needs common/frame.glsl,
// AGAA_BINDING_DEFERRED and AGAA_REGION_SIDE. The consuming pass defines AGAA_CONSUMES_DEFERRED.
#ifndef AGAA_DEFERRED_PIXELS_GLSL
#define AGAA_DEFERRED_PIXELS_GLSL
#if !defined(AGAA_FRAME_GLSL) || !defined(AGAA_BINDING_DEFERRED) || !defined(AGAA_REGION_SIDE)
#error "deferred_pixels.glsl needs frame.glsl, AGAA_BINDING_DEFERRED and AGAA_REGION_SIDE."
#endif
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

// Defers this lane's pixel of the tile. All lanes must call it.
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

// Defers one more pixel after agaa_deferPixel() has run for all tiles of the group.
void agaa_deferLate(uvec2 pixel) {
    uint lane = pixel.x & 7u | (pixel.y & 7u) << 3u;
    atomicOr(agaa_deferred.words[agaa_deferredWord(pixel / 8u, lane)], 1u << (lane & 31u));
}
#else
const uint agaa_maxDeferred = 64u * AGAA_REGION_SIDE * AGAA_REGION_SIDE;
shared uint agaa_deferredCount;
// Bytes of pixels: lane in its tile | tile << 6, which takes regions of up to 4 tiles.
shared uint agaa_deferredPixels[agaa_maxDeferred / 4u];
uint agaa_firstDeferred = 0u; // index of the first pixel of the current iteration, in which each lane has one

// Lists the deferred pixels of the region and returns their number. All lanes must call it.
uint agaa_findDeferred() {
    const uint lane = gl_LocalInvocationIndex;
    if (lane == 0u)
        agaa_deferredCount = 0u;
    if (lane < agaa_maxDeferred / 4u)
        agaa_deferredPixels[lane] = 0u;
    barrier();
    for (uint t = 0u; t < AGAA_REGION_SIDE * AGAA_REGION_SIDE; ++t) {
        uvec2 tile = gl_WorkGroupID.xy * AGAA_REGION_SIDE + uvec2(t % AGAA_REGION_SIDE, t / AGAA_REGION_SIDE);
        if (any(greaterThanEqual(tile, agaa_tileCounts())))
            continue;
        if ((agaa_deferred.words[agaa_deferredWord(tile, lane)] >> (lane & 31u) & 1u) != 0u) {
            uint index = atomicAdd(agaa_deferredCount, 1u);
            atomicOr(agaa_deferredPixels[index >> 2u], (lane | t << 6u) << 8u * (index & 3u));
        }
    }
    barrier();
    return agaa_deferredCount;
}

// Returns the pixel of a lane in the current iteration.
uvec2 agaa_pixelOf(uint lane) {
    uint index = min(agaa_firstDeferred + lane, agaa_maxDeferred - 1u);
    uint entry = agaa_deferredPixels[index >> 2u] >> 8u * (index & 3u) & 0xFFu;
    uint tile = entry >> 6u;
    uvec2 corner = gl_WorkGroupID.xy * AGAA_REGION_SIDE + uvec2(tile % AGAA_REGION_SIDE, tile / AGAA_REGION_SIDE);
    return corner * 8u + uvec2(entry & 7u, entry >> 3u & 7u);
}
#endif
#endif
