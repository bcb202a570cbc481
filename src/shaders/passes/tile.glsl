// Shading events of a tile of pixels, dealt out so that every lane has one: the pixels of a tile need different
// numbers of them (Lauritzen 2010: per-sample shading of complex pixels).
#ifndef AGAA_TILE_GLSL
#define AGAA_TILE_GLSL
#include "passes/debug_view.glsl"

// What a pixel has to shade: the events whose bits are set, each of the kind given.
struct agaa_PixelWork {
    uint events;
    uint kind;    // a multiple of 32
    uint covered; // samples with geometry
};

// Of the shader that includes this.
// Radiance, or agaa_shownOfEvent(), times the number of samples that the event stands for. which: bit and kind.
vec3 agaa_shadeEvent(uvec2 pixel, uint which);

shared uint agaa_eventCount;
shared uint agaa_events[64u * AGAA_MAX_EVENTS]; // place in the tile | which << 8
shared vec3 agaa_eventColor[64];

// The sum of what the events of this lane's pixel give. Called by all lanes; corner: of the tile.
vec3 agaa_shadeWork(agaa_PixelWork work, uvec2 corner) {
    const uint lane = gl_LocalInvocationIndex;
    if (lane == 0u)
        agaa_eventCount = 0u;
    barrier();
    // Where a pixel's events come to lie differs from run to run, their sum does not.
    uint first = atomicAdd(agaa_eventCount, uint(bitCount(work.events)));
    uint end = first;
    for (uint left = work.events; left != 0u; left &= left - 1u)
        agaa_events[end++] = lane | (uint(findLSB(left)) | work.kind) << 8u;
    barrier();
    uint count = agaa_eventCount;
    vec3 color = vec3(0.0);
    for (uint base = 0u; base < count; base += 64u) {
        if (base + lane < count) {
            uint event = agaa_events[base + lane];
            uvec2 place = corner + uvec2(event & 7u, event >> 3u & 7u);
            agaa_eventColor[lane] = agaa_shadeEvent(place, event >> 8u);
        }
        barrier();
        for (uint i = max(first, base); i < min(end, base + 64u); ++i)
            color += agaa_eventColor[i - base];
        barrier();
    }
    return color;
}

void agaa_writePixel(uvec2 pixel, agaa_PixelWork work, vec3 color) {
    if (AGAA_DEBUG_VIEW != 0u) {
        vec3 mean = color / float(max(work.covered, 1u));
        agaa_writeOutput(pixel, agaa_shownOfPixel(uint(bitCount(work.events)), mean), AGAA_SAMPLES);
    } else {
        agaa_writeOutput(pixel, color / float(AGAA_SAMPLES), work.covered);
    }
}

#ifndef AGAA_OWN_TILE // shaders that find the work of a tile together
agaa_PixelWork agaa_workOf(uvec2 pixel);

void agaa_shadeTile() {
    uvec2 corner = gl_WorkGroupID.xy * 8u;
    uvec2 pixel = corner + gl_LocalInvocationID.xy;
    bool inside = all(lessThan(pixel, agaa_frame.size.xy));
    agaa_PixelWork work = agaa_PixelWork(0u, 0u, 0u);
    if (inside)
        work = agaa_workOf(pixel);
    vec3 color = agaa_shadeWork(work, corner);
    if (inside)
        agaa_writePixel(pixel, work, color);
}
#endif
#endif
