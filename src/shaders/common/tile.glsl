// Shades a tile of 8 by 8 pixels per workgroup. Needs AGAA_MAX_EVENTS. With AGAA_FINDS_LIGHTS (common/lighting.glsl),
// agaa_workOf() adds the pixel's events to the tile (agaa_addToTile()).
#ifndef AGAA_TILE_GLSL
#define AGAA_TILE_GLSL
#include "common/events.glsl"
#include "common/tile_pixels.glsl"

// The includer defines this function, which returns the shading events of a pixel.
agaa_PixelWork agaa_workOf(uvec2 pixel);

void agaa_shadeTile() {
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool inside = all(lessThan(pixel, agaa_frame.size));
    agaa_PixelWork work = agaa_pixelWork(0u, 0u, 0u);
#ifdef AGAA_FINDS_LIGHTS
    agaa_beginTileLights();
#endif
    if (inside)
        work = agaa_workOf(pixel);
#ifdef AGAA_FINDS_LIGHTS
    agaa_findTileLights(); // agaa_shadeWork() has the barrier
#endif
    vec3 color = agaa_shadeWork(work);
    if (inside)
        agaa_writePixel(pixel, work, color);
}
#endif
