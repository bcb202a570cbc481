// The pixel of each lane, if a workgroup processes a tile of 8 by 8 pixels. Passes that define AGAA_ORDERS_PIXELS
// choose which lane has which pixel of the tile.
#ifndef AGAA_TILE_PIXELS_GLSL
#define AGAA_TILE_PIXELS_GLSL
#ifdef AGAA_ORDERS_PIXELS
shared uint agaa_pixelsOfLanes[64]; // index of each lane's pixel in the tile
uint agaa_pixelIndex(uint lane) { return agaa_pixelsOfLanes[lane]; }
#else
uint agaa_pixelIndex(uint lane) { return lane; }
#endif

uvec2 agaa_pixelOf(uint lane) {
    uint i = agaa_pixelIndex(lane);
    return gl_WorkGroupID.xy * 8u + uvec2(i & 7u, i >> 3u);
}
#endif
