// The shading events of a pixel, and the output of their sum.
#ifndef AGAA_PIXEL_WORK_GLSL
#define AGAA_PIXEL_WORK_GLSL
#include "common/debug_view.glsl"
#include "common/output.glsl"

// Number of words of a mask of events. A shader with more than 32 events per pixel defines it first.
#ifndef AGAA_EVENT_WORDS
#define AGAA_EVENT_WORDS 1
#endif

// A mask of events, all of one kind.
struct agaa_PixelWork {
    uint events[AGAA_EVENT_WORDS];
    uint kind;    // a multiple of 32 * AGAA_EVENT_WORDS
    uint covered; // samples with geometry
};

// events   The first word of the mask.
agaa_PixelWork agaa_pixelWork(uint events, uint kind, uint covered) {
    agaa_PixelWork work;
    for (uint word = 0u; word < uint(AGAA_EVENT_WORDS); ++word)
        work.events[word] = word == 0u ? events : 0u;
    work.kind = kind;
    work.covered = covered;
    return work;
}

uint agaa_eventsOf(agaa_PixelWork work) {
    uint count = 0u;
    for (uint word = 0u; word < uint(AGAA_EVENT_WORDS); ++word)
        count += uint(bitCount(work.events[word]));
    return count;
}

void agaa_writePixel(uvec2 pixel, agaa_PixelWork work, vec3 color) {
    if (AGAA_DEBUG_VIEW != AGAA_DEBUG_VIEW_NONE) {
        vec3 mean = color / float(max(work.covered, 1u));
        agaa_writeOutput(pixel, agaa_shownOfPixel(agaa_eventsOf(work), mean), AGAA_SAMPLES);
    } else {
        agaa_writeOutput(pixel, color / float(AGAA_SAMPLES), work.covered);
    }
}
#endif
