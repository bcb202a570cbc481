// Counters of compute passes. Lanes count in shared memory, because counts in registers of each lane leave GPUs fewer
// waves. A workgroup adds its counts to the frame's 64-bit counters once. Needs AGAA_COUNTING.
#ifndef AGAA_COUNTERS_GLSL
#define AGAA_COUNTERS_GLSL
#ifndef AGAA_COUNTING
#error "counters.glsl needs AGAA_COUNTING."
#endif
#include "common/api_values.glsl"
#include "tables/layouts.inc"

#define AGAA_COUNTER(index, name, member) const uint name = index;
#define AGAA_COUNTER_MAX(index, name, member) const uint name = index;
#define AGAA_COUNTER_FACT(index, name, member, fact) const uint name = index;
#include "tables/counters.inc"
#undef AGAA_COUNTER
#undef AGAA_COUNTER_MAX
#undef AGAA_COUNTER_FACT
const uint AGAA_COUNTS = AGAA_COUNT_MAX_EVENTS + 1u;

#if AGAA_COUNTING
layout(std430, AGAA_BINDING_COUNTERS) coherent buffer agaa_CounterBlock {
    uint words[2u * AGAA_COUNTS];
    uint invalidPixelCount; // with uncovered or overlapping samples
    uint padding;
    uint invalidPixels[AGAA_MAX_INVALID_PIXELS][AGAA_INVALID_PIXEL_WORDS];
} agaa_counterBuffer;

shared uint agaa_groupCounts[AGAA_COUNTS]; // the last is the largest number of events of a pixel

void agaa_countBegin() {
    if (gl_LocalInvocationIndex < AGAA_COUNTS)
        agaa_groupCounts[gl_LocalInvocationIndex] = 0u;
    barrier();
}
void agaa_count(uint which, uint amount) {
    if (amount != 0u)
        atomicAdd(agaa_groupCounts[which], amount);
}
// Counts the events of one pixel.
void agaa_countEvents(uint count) {
    if (count == 0u)
        return;
    uint bin = min(uint(findMSB(count - 1u) + 1), AGAA_COUNT_PIXELS_OF_MORE - AGAA_COUNT_PIXELS_OF_1);
    atomicAdd(agaa_groupCounts[AGAA_COUNT_EVENTS], count);
    atomicAdd(agaa_groupCounts[AGAA_COUNT_PIXELS_OF_1 + bin], 1u);
    atomicMax(agaa_groupCounts[AGAA_COUNT_MAX_EVENTS], count);
}
// Reports samples of the pixel about which the geometry passes disagree.
void agaa_reportPixel(uvec2 pixel, uvec4 visible, uvec4 uncovered, uvec4 overlapping) {
    uint index = atomicAdd(agaa_counterBuffer.invalidPixelCount, 1u);
    if (index >= AGAA_MAX_INVALID_PIXELS)
        return;
    agaa_counterBuffer.invalidPixels[index][0] = pixel.x;
    agaa_counterBuffer.invalidPixels[index][1] = pixel.y;
    for (uint word = 0u; word < 4u; ++word) {
        agaa_counterBuffer.invalidPixels[index][AGAA_INVALID_VISIBLE_AT + word] = visible[word];
        agaa_counterBuffer.invalidPixels[index][AGAA_INVALID_UNCOVERED_AT + word] = uncovered[word];
        agaa_counterBuffer.invalidPixels[index][AGAA_INVALID_OVERLAPPING_AT + word] = overlapping[word];
    }
}
void agaa_reportPixel(uvec2 pixel, uint visible, uint uncovered, uint overlapping) {
    agaa_reportPixel(pixel, uvec4(visible, 0u, 0u, 0u), uvec4(uncovered, 0u, 0u, 0u), uvec4(overlapping, 0u, 0u, 0u));
}
void agaa_countEnd() {
    barrier();
    uint i = gl_LocalInvocationIndex;
    // The index is in range for all invocations, because Mesa reads the right side of && regardless of the left side.
    uint count = agaa_groupCounts[min(i, AGAA_COUNT_MAX_EVENTS)];
    if (i < AGAA_COUNT_MAX_EVENTS && count != 0u) {
        uint before = atomicAdd(agaa_counterBuffer.words[2u * i], count);
        if (before + count < before) // overflow
            atomicAdd(agaa_counterBuffer.words[2u * i + 1u], 1u);
    }
    if (i == AGAA_COUNT_MAX_EVENTS)
        atomicMax(agaa_counterBuffer.words[2u * i], count);
}
#else
void agaa_countBegin() {}
void agaa_count(uint which, uint amount) {}
void agaa_countEvents(uint count) {}
void agaa_countEnd() {}
#endif
#endif
