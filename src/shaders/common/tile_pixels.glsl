// The pixel of each lane, if a workgroup processes a tile of 8 by 8 pixels.
#ifndef AGAA_TILE_PIXELS_GLSL
#define AGAA_TILE_PIXELS_GLSL
uvec2 agaa_pixelOf(uint lane) { return gl_WorkGroupID.xy * 8u + uvec2(lane & 7u, lane >> 3u); }
#endif
