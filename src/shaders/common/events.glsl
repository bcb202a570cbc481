// Shading events of 64 pixels, dealt out so that every lane has one: pixels need different numbers of them (Lauritzen
// 2010: per-sample shading of complex pixels).
#ifndef AGAA_EVENTS_GLSL
#define AGAA_EVENTS_GLSL
#include "common/pixel_work.glsl"

// Of the shader that includes this.
// Radiance, or agaa_shownOfEvent(), times the number of samples that the event stands for. lane: of its pixel; which:
// bit and kind.
vec3 agaa_shadeEvent(uint lane, uint which);

shared uint agaa_eventCount;
shared uint agaa_events[64u * AGAA_MAX_EVENTS]; // lane | which << 8
shared vec3 agaa_eventColor[64];

// The sum of what the events of this lane's pixel give. Called by all lanes.
vec3 agaa_shadeWork(agaa_PixelWork work) {
    const uint lane = gl_LocalInvocationIndex;
    if (lane == 0u)
        agaa_eventCount = 0u;
    barrier();
    // Where a pixel's events come to lie differs from run to run, their sum does not.
    uint first = atomicAdd(agaa_eventCount, agaa_eventsOf(work));
    uint end = first;
    for (uint word = 0u; word < uint(AGAA_EVENT_WORDS); ++word)
        for (uint left = work.events[word]; left != 0u; left &= left - 1u)
            agaa_events[end++] = lane | (32u * word + uint(findLSB(left)) | work.kind) << 8u;
    barrier();
    uint count = agaa_eventCount;
    vec3 color = vec3(0.0);
    // Tested at its end, as are other loops that lanes leave together: software rasterisers, whose lanes are masked,
    // run what follows a test once more than lanes want it. Where lanes leave at different turns, sums of what was
    // loaded come out wrong so on Mesa 22.3's Vulkan.
    uint base = 0u;
    do {
        if (base + lane < count) {
            uint event = agaa_events[base + lane];
            agaa_eventColor[lane] = agaa_shadeEvent(event & 63u, event >> 8u);
        }
        barrier();
        for (uint i = max(first, base); i < min(end, base + 64u); ++i)
            color += agaa_eventColor[i - base];
        barrier();
        base += 64u;
    } while (base < count);
    return color;
}
#endif
