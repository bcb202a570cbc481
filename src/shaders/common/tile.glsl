// Shading of tiles of 8 by 8 pixels, one a workgroup.
#ifndef AGAA_TILE_GLSL
#define AGAA_TILE_GLSL
#include "common/events.glsl"
#include "common/tile_pixels.glsl"

// Of the shader that includes this.
agaa_PixelWork agaa_workOf(uvec2 pixel);

void agaa_shadeTile() {
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool inside = all(lessThan(pixel, agaa_frame.size));
    agaa_PixelWork work = agaa_pixelWork(0u, 0u, 0u);
    if (inside)
        work = agaa_workOf(pixel);
    vec3 color = agaa_shadeWork(work);
    if (inside)
        agaa_writePixel(pixel, work, color);
}
#endif
