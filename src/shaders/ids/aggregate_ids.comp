// Aggregates the fetched materials of pixels with several primitives and shades the aggregates at once. It writes only
// the image.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/subgroup_extensions.glsl"
#if AGAA_SAMPLE_LANES
#define AGAA_MAX_SAMPLES 1
#define AGAA_SAMPLE_WORDS AGAA_SAMPLES
layout(local_size_x = 64) in;
#else
#define AGAA_MAX_SAMPLES AGAA_SAMPLES
layout(local_size_x = 8, local_size_y = 8) in;
#endif
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#define AGAA_CONSUMES_DEFERRED
#include "ids/deferred_pixels.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "ids/primitive_list.glsl"
#include "common/events.glsl"
#include "aggregate/aggregate_lighting.glsl"
#include "ids/primitives.glsl"
#include "ids/primitive_means.glsl"

// Returns means over these samples of the pixel of a lane.
agaa_Means agaa_meansOf(uint lane, uint mask, float scale, bool isLit) {
    agaa_Means m = agaa_noMeans();
    uvec2 entries = agaa_entriesOf(lane);
    for (uint at = entries.x; at < entries.y; ++at) {
        uint samples = agaa_listSamples[at] & mask;
        if (samples != 0u)
            agaa_addPrimitive(m, agaa_listMaterial[at], samples, scale, isLit);
    }
    return m;
}

#if AGAA_LIT
uint agaa_eventLane = 0u; // the lane of the event's pixel

agaa_Means agaa_litMeans(uvec2 pixel, uint mask, float scale) {
    return agaa_meansOf(agaa_eventLane, mask, scale, true);
}
#endif

vec3 agaa_shadeEvent(uint lane, uint a) {
    uvec2 pixel = agaa_pixelOf(lane);
#if AGAA_LIT
    agaa_eventLane = lane;
#endif
    uint mask = agaa_masks[lane * AGAA_AGGREGATES + a];
    agaa_Means means = agaa_meansOf(lane, mask, 1.0 / float(bitCount(mask)), false);
    return agaa_shadeMeans(pixel, agaa_locateAggregate(pixel, mask), a, mask, means, false);
}

void agaa_shadeDeferredPixel(bool hasPixel, uvec2 pixel, uint covered, uint uncovered) {
    agaa_PixelWork work = agaa_pixelWork(0u, 0u, 0u);
    if (hasPixel)
        work = agaa_countedWork(pixel, agaa_aggregatesOf(gl_LocalInvocationIndex), covered, uncovered);
    vec3 color = agaa_shadeWork(work);
    if (hasPixel)
        agaa_writePixel(pixel, work, color);
}

void main() {
    agaa_countBegin();
    uint count = agaa_findDeferred();
    agaa_firstDeferred = 0u;
    do {
        bool hasPixel = agaa_firstDeferred + gl_LocalInvocationIndex < count;
        uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
        agaa_processPixels(pixel, hasPixel ? agaa_loadIds(pixel) : 0u);
        barrier();
        agaa_firstDeferred += 64u;
    } while (agaa_firstDeferred < count);
    agaa_countEnd();
}
