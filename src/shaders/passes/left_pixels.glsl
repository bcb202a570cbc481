// Pixels that one pass leaves to another: a bit each, two words a tile of 8 by 8. A group of the pass that takes them has
// a region of tiles, so that its lanes are full where tiles leave few pixels.
#ifndef AGAA_LEFT_PIXELS_GLSL
#define AGAA_LEFT_PIXELS_GLSL
#ifdef AGAA_TAKES_LEFT
#define AGAA_LEFT_ACCESS readonly
#else
#define AGAA_LEFT_ACCESS coherent
#endif
layout(std430, AGAA_AT_LEFT) AGAA_LEFT_ACCESS buffer agaa_LeftBlock {
    uint words[];
} agaa_left;

uvec2 agaa_tileCounts() { return (agaa_frame.size.xy + 7u) / 8u; }

uint agaa_leftWord(uvec2 tile, uint lane) { return 2u * (tile.y * agaa_tileCounts().x + tile.x) + (lane >> 5u); }

#ifndef AGAA_TAKES_LEFT
shared uint agaa_leftHere[2];

// Called by all lanes, which have a pixel of the tile each.
void agaa_leavePixel(uvec2 tile, bool isLeft) {
    const uint lane = gl_LocalInvocationIndex;
    if (lane < 2u)
        agaa_leftHere[lane] = 0u;
    barrier();
    if (isLeft)
        atomicOr(agaa_leftHere[lane >> 5u], 1u << (lane & 31u));
    barrier();
    if (lane < 2u && all(lessThan(tile, agaa_tileCounts())))
        agaa_left.words[agaa_leftWord(tile, 32u * lane)] = agaa_leftHere[lane];
}

// One more, after all tiles of the group were sorted.
void agaa_leaveLate(uvec2 pixel) {
    uint lane = pixel.x & 7u | (pixel.y & 7u) << 3u;
    atomicOr(agaa_left.words[agaa_leftWord(pixel / 8u, lane)], 1u << (lane & 31u));
}
#else
const uint agaa_mostLeft = 64u * AGAA_REGION_SIDE * AGAA_REGION_SIDE;
shared uint agaa_leftCount;
shared uint agaa_leftPlace[agaa_mostLeft]; // lane in its tile | tile << 6
uint agaa_turn = 0u; // place of the first pixel in hand; a lane has one each

// Called by all lanes; returns how many there are in the region.
uint agaa_findLeft() {
    const uint lane = gl_LocalInvocationIndex;
    if (lane == 0u)
        agaa_leftCount = 0u;
    barrier();
    for (uint t = 0u; t < AGAA_REGION_SIDE * AGAA_REGION_SIDE; ++t) {
        uvec2 tile = gl_WorkGroupID.xy * AGAA_REGION_SIDE + uvec2(t % AGAA_REGION_SIDE, t / AGAA_REGION_SIDE);
        if (any(greaterThanEqual(tile, agaa_tileCounts())))
            continue;
        if ((agaa_left.words[agaa_leftWord(tile, lane)] >> (lane & 31u) & 1u) != 0u)
            agaa_leftPlace[atomicAdd(agaa_leftCount, 1u)] = lane | t << 6u;
    }
    barrier();
    return agaa_leftCount;
}

// That a lane has in hand.
uvec2 agaa_pixelOf(uint lane) {
    uint place = agaa_leftPlace[min(agaa_turn + lane, agaa_mostLeft - 1u)];
    uint tile = place >> 6u;
    uvec2 corner = gl_WorkGroupID.xy * AGAA_REGION_SIDE + uvec2(tile % AGAA_REGION_SIDE, tile / AGAA_REGION_SIDE);
    return corner * 8u + uvec2(place & 7u, place >> 3u & 7u);
}
#endif
#endif
