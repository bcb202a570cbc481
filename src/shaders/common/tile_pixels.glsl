// The pixel of each lane, if a workgroup processes a tile of 8 by 8 pixels. In passes that define AGAA_ORDERS_PIXELS,
// coverage/pixel_order.glsl chooses the lanes' pixels.
#ifndef AGAA_TILE_PIXELS_GLSL
#define AGAA_TILE_PIXELS_GLSL
#ifdef AGAA_ORDERS_PIXELS
uint agaa_orderedPixel(uint lane); // returns an index in the tile
#else
uint agaa_orderedPixel(uint lane) { return lane; }
#endif

uvec2 agaa_pixelOf(uint lane) {
    uint i = agaa_orderedPixel(lane);
    return gl_WorkGroupID.xy * 8u + uvec2(i & 7u, i >> 3u);
}
#endif
