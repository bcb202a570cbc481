// Aggregates of what a pixel's ids name, shaded at once: nothing but the image goes to memory.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_MAX_SAMPLES 32
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/lighting.glsl"
#include "passes/output.glsl"
#include "passes/aggregate.glsl"
#include "passes/primitives.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#define AGAA_OWN_TILE
#include "passes/tile.glsl"

agaa_PixelWork agaa_countedWork(uvec2 pixel, uint count, uint covered, uint missed) {
    uint samples = uint(bitCount(covered));
    agaa_count(AGAA_COUNT_VISIBLE, uint(bitCount(covered | missed)));
    agaa_count(AGAA_COUNT_ONCE, samples);
#if AGAA_COUNTING
    agaa_count(AGAA_COUNT_MISSED, uint(bitCount(missed)));
    if (missed != 0u)
        agaa_reportPixel(pixel, covered | missed, missed, 0u);
#endif
    agaa_count(AGAA_COUNT_EVENTS, count);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_PixelWork((1u << count) - 1u, 0u, samples);
}

// The means over samples: of each primitive as often as it has samples. lane: of the pixel.
agaa_Means agaa_meansOf(uint lane, uint mask) {
    agaa_Means m = agaa_noMeans();
    float share = 1.0 / float(bitCount(mask));
    uint list = agaa_pixelList[lane];
    uint end = (list & 0xFFFFu) + (list >> 16u);
    for (uint at = list & 0xFFFFu; at < end; ++at) {
        float weight = share * float(bitCount(agaa_listSamples[at] & mask));
        if (weight > 0.0)
            agaa_addToMeans(m, weight, agaa_listedSurface(at));
    }
    return m;
}

uint agaa_laneOf(uvec2 pixel) { return (pixel.y & 7u) * 8u + (pixel.x & 7u); }

#if AGAA_LIT
agaa_Means agaa_litMeans(uvec2 pixel, uint mask, float scale) {
    agaa_Means m = agaa_noMeans();
    uint list = agaa_pixelList[agaa_laneOf(pixel)];
    uint end = (list & 0xFFFFu) + (list >> 16u);
    for (uint at = list & 0xFFFFu; at < end; ++at) {
        float weight = 0.0;
        for (uint rest = agaa_listSamples[at] & mask; rest != 0u; rest &= rest - 1u)
            weight += agaa_sampleLight[findLSB(rest)];
        if (weight > 0.0)
            agaa_addToMeans(m, scale * weight, agaa_listedSurface(at));
    }
    return m;
}
#endif

vec3 agaa_shadeEvent(uvec2 pixel, uint a) {
    uint lane = agaa_laneOf(pixel);
    uint mask = agaa_masks[lane * AGAA_AGGREGATES + a];
    return agaa_shadeMeans(pixel, agaa_placeAggregate(pixel, mask), a, mask, agaa_meansOf(lane, mask), false);
}

void agaa_takePixel(bool isHeld, uvec2 corner, uvec2 pixel, uint covered, uint missed) {
    agaa_PixelWork work = agaa_PixelWork(0u, 0u, 0u);
    if (isHeld)
        work = agaa_countedWork(pixel, agaa_aggregateCount[gl_LocalInvocationIndex], covered, missed);
    vec3 color = agaa_shadeWork(work, corner);
    if (isHeld)
        agaa_writePixel(pixel, work, color);
}

void main() {
    agaa_countBegin();
    uvec2 corner = gl_WorkGroupID.xy * 8u;
    uvec2 pixel = corner + gl_LocalInvocationID.xy;
    bool inside = all(lessThan(pixel, agaa_frame.size.xy));
    uint covered = inside ? agaa_loadIds(pixel) : 0u;
    if (inside && covered == 0u)
        agaa_writePixel(pixel, agaa_PixelWork(0u, 0u, 0u), vec3(0.0));
    agaa_takeTile(corner, pixel, covered);
    agaa_countEnd();
}
