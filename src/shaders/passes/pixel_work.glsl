// What a pixel has to shade, and what becomes of it.
#ifndef AGAA_PIXEL_WORK_GLSL
#define AGAA_PIXEL_WORK_GLSL
#include "passes/debug_view.glsl"
#include "passes/output.glsl"

// Events whose bits are set, each of the kind given.
struct agaa_PixelWork {
    uint events;
    uint kind;    // a multiple of 32
    uint covered; // samples with geometry
};

void agaa_writePixel(uvec2 pixel, agaa_PixelWork work, vec3 color) {
    if (AGAA_DEBUG_VIEW != 0u) {
        vec3 mean = color / float(max(work.covered, 1u));
        agaa_writeOutput(pixel, agaa_shownOfPixel(uint(bitCount(work.events)), mean), AGAA_SAMPLES);
    } else {
        agaa_writeOutput(pixel, color / float(AGAA_SAMPLES), work.covered);
    }
}
#endif
