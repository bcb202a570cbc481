// Aggregates the samples of a multisampled G-buffer and shades the aggregates at once. It writes only the image.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_MAX_SAMPLES AGAA_SAMPLES
#define AGAA_FROM_GBUFFER 1
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "aggregate/aggregate_lighting.glsl"
#include "aggregate/samples.glsl"
#include "aggregate/grouping.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "common/tile.glsl"

shared uint agaa_masks[64u * AGAA_AGGREGATES]; // samples of each aggregate

bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered) { return true; }

void agaa_weighNormals(uvec2 pixel, uint covered) { agaa_weighFetchedNormals(pixel, covered); }

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    agaa_PixelSamples samples = agaa_loadSamples(pixel);
    uint count = agaa_groupSamples(pixel, samples, agaa_sampleCount());
    uint base = gl_LocalInvocationIndex * AGAA_AGGREGATES;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
        agaa_masks[base + a] = a == 0u && count == 1u ? samples.covered : 0u;
    if (count > 1u)
        for (uint left = samples.covered; left != 0u; left &= left - 1u) {
            uint i = uint(findLSB(left));
            agaa_masks[base + agaa_sampleAggregate[i]] |= 1u << i;
        }
    uint covered = uint(bitCount(samples.covered));
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_countEvents(count);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_pixelWork((1u << count) - 1u, 0u, covered);
}

agaa_Means agaa_meansOf(uvec2 pixel, uint mask) {
    agaa_Means m = agaa_noMeans();
    float share = 1.0 / float(bitCount(mask));
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        agaa_fetchSample(pixel, uint(findLSB(rest)));
        agaa_addToMeans(m, share, agaa_sampleSurface());
    }
    return m;
}

#if AGAA_LIT
agaa_Means agaa_litMeans(uvec2 pixel, uint mask, float scale) {
    agaa_Means m = agaa_noMeans();
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        agaa_fetchSample(pixel, i);
        agaa_addToMeans(m, scale * agaa_sampleLight[i], agaa_sampleSurface());
    }
    return m;
}
#endif

vec3 agaa_shadeEvent(uint lane, uint a) {
    uvec2 pixel = agaa_pixelOf(lane);
    uint mask = agaa_masks[lane * AGAA_AGGREGATES + a];
    return agaa_shadeMeans(pixel, agaa_locateAggregate(pixel, mask), a, mask, agaa_meansOf(pixel, mask), false);
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
