// Compacts the shading events of 64 pixels so that all lanes are busy, because pixels have different numbers of events
// (Lauritzen 2010: per-sample shading of complex pixels). Needs AGAA_MAX_EVENTS, the largest number of events of a
// pixel. The includer may define AGAA_EVENT_WORD(word): 32 * AGAA_MAX_EVENTS + 192 words of shared memory that it does
// not need while events are shaded. Its events then have a `which` below 256.
#ifndef AGAA_EVENTS_GLSL
#define AGAA_EVENTS_GLSL
#ifndef AGAA_MAX_EVENTS
#error "events.glsl needs AGAA_MAX_EVENTS."
#endif
#include "common/pixel_work.glsl"

// The includer defines this function. It returns radiance, or agaa_shownOfEvent(), times the number of samples that the
// event represents.
// lane    The lane of the pixel.
// which   Bit and kind of the event (agaa_PixelWork).
vec3 agaa_shadeEvent(uint lane, uint which);

shared uint agaa_eventCount;
#ifdef AGAA_EVENT_WORD
// Two events per word, then the colours.
void agaa_clearEvents() {
    for (uint word = gl_LocalInvocationIndex; word < 32u * AGAA_MAX_EVENTS; word += 64u)
        AGAA_EVENT_WORD(word) = 0u;
}
void agaa_putEvent(uint index, uint event) { atomicOr(AGAA_EVENT_WORD(index >> 1u), event << 16u * (index & 1u)); }
uint agaa_eventAt(uint index) { return AGAA_EVENT_WORD(index >> 1u) >> 16u * (index & 1u) & 0xFFFFu; }

const uint agaa_firstColorWord = 32u * AGAA_MAX_EVENTS;
void agaa_putColor(uint index, vec3 color) {
    AGAA_EVENT_WORD(agaa_firstColorWord + index) = floatBitsToUint(color.x);
    AGAA_EVENT_WORD(agaa_firstColorWord + 64u + index) = floatBitsToUint(color.y);
    AGAA_EVENT_WORD(agaa_firstColorWord + 128u + index) = floatBitsToUint(color.z);
}
vec3 agaa_colorAt(uint index) {
    return uintBitsToFloat(uvec3(AGAA_EVENT_WORD(agaa_firstColorWord + index),
                                 AGAA_EVENT_WORD(agaa_firstColorWord + 64u + index),
                                 AGAA_EVENT_WORD(agaa_firstColorWord + 128u + index)));
}
#else
shared uint agaa_events[64u * AGAA_MAX_EVENTS]; // lane | which << 8
shared vec3 agaa_eventColor[64];
void agaa_clearEvents() {}
void agaa_putEvent(uint index, uint event) { agaa_events[index] = event; }
uint agaa_eventAt(uint index) { return agaa_events[index]; }
void agaa_putColor(uint index, vec3 color) { agaa_eventColor[index] = color; }
vec3 agaa_colorAt(uint index) { return agaa_eventColor[index]; }
#endif

// Shades the events of all lanes' pixels and returns the sum over this lane's pixel. All lanes must call it.
vec3 agaa_shadeWork(agaa_PixelWork work) {
    const uint lane = gl_LocalInvocationIndex;
    if (lane == 0u)
        agaa_eventCount = 0u;
    agaa_clearEvents();
    barrier();
    // The order of pixels in the list differs from run to run. The sum over one pixel does not.
    uint first = atomicAdd(agaa_eventCount, agaa_eventsOf(work));
    uint end = first;
    for (uint word = 0u; word < uint(AGAA_EVENT_WORDS); ++word)
        for (uint left = work.events[word]; left != 0u; left &= left - 1u)
            agaa_putEvent(end++, lane | (32u * word + uint(findLSB(left)) | work.kind) << 8u);
    barrier();
    uint count = agaa_eventCount;
    vec3 color = vec3(0.0);
    // Loops that all lanes leave together test at their end, because software rasterisers with masked lanes run the
    // code after a test once more than needed. If lanes left at different iterations, Mesa 22.3's Vulkan driver would
    // return wrong sums of loaded values.
    uint base = 0u;
    do {
        if (base + lane < count) {
            uint event = agaa_eventAt(base + lane);
            agaa_putColor(lane, agaa_shadeEvent(event & 63u, event >> 8u));
        }
        barrier();
        for (uint i = max(first, base); i < min(end, base + 64u); ++i)
            color += agaa_colorAt(i - base);
        barrier();
        base += 64u;
    } while (base < count);
    return color;
}
#endif
