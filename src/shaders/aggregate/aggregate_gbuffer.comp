// Aggregates the samples of a multisampled G-buffer and shades the aggregates at once. It writes only the image.
// Samples are grouped with one lane per pixel or, with AGAA_SAMPLE_LANES, per sample.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/subgroup_extensions.glsl"
#define AGAA_FROM_GBUFFER 1
#if AGAA_SAMPLE_LANES
#define AGAA_MAX_SAMPLES 1
#if AGAA_LIT
#define AGAA_SAMPLE_WORDS AGAA_SAMPLES
#endif
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
#include "aggregate/aggregate_lighting.glsl"
#include "aggregate/samples.glsl"
#include "math/sbaa_surfaces.glsl"
#if AGAA_SAMPLE_LANES
#include "aggregate/lane_samples.glsl"
#else
#include "aggregate/grouping.glsl"
#endif
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "common/tile.glsl"

shared uint agaa_masks[64u * AGAA_AGGREGATES]; // samples of each aggregate

// Counts a pixel and returns its work.
// count   Number of the pixel's aggregates.
agaa_PixelWork agaa_countedWork(uint count, uint samples) {
    uint covered = uint(bitCount(samples));
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_countEvents(count);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_pixelWork((1u << count) - 1u, 0u, covered);
}

#if AGAA_SAMPLE_LANES
shared uint agaa_aggregateCount[64]; // of each pixel
shared uint agaa_coveredSamples[64];

// Groups the samples of all pixels of the tile. All lanes must call it.
void agaa_groupTile() {
    for (uint iteration = 0u; iteration < agaa_pixelLanes; ++iteration) {
        uint lane = agaa_lanePixel(iteration);
        agaa_LaneSample s = agaa_loadLaneSample(agaa_pixelOf(lane));
        agaa_LaneGroup group = agaa_groupLanes(s, false);
        for (uint a = 0u; a < AGAA_AGGREGATES; ++a) {
            uint mask = agaa_samplesOf(s, group, a);
            if (agaa_laneSample() == 0u)
                agaa_masks[lane * AGAA_AGGREGATES + a] = mask;
        }
        if (agaa_laneSample() == 0u) {
            agaa_count(AGAA_COUNT_JOINED_CLASSES, uint(bitCount(group.joining)));
            agaa_aggregateCount[lane] = group.count;
            agaa_coveredSamples[lane] = group.covered;
        }
    }
    barrier();
}

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    const uint lane = gl_LocalInvocationIndex;
    return agaa_countedWork(agaa_aggregateCount[lane], agaa_coveredSamples[lane]);
}
#else
void agaa_groupTile() {}

bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered) { return true; }

void agaa_weighNormals(uvec2 pixel, uint covered) { agaa_weighFetchedNormals(pixel, covered); }

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    agaa_PixelSamples samples = agaa_loadSamples(pixel);
    uint count = agaa_groupSamples(pixel, samples, agaa_sampleCount());
    agaa_count(AGAA_COUNT_JOINED_CLASSES, uint(bitCount(agaa_joiningSamples)));
    uint base = gl_LocalInvocationIndex * AGAA_AGGREGATES;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
        agaa_masks[base + a] = a == 0u && count == 1u ? samples.covered : 0u;
    if (count > 1u)
        for (uint left = samples.covered; left != 0u; left &= left - 1u) {
            uint i = uint(findLSB(left));
            agaa_masks[base + agaa_sampleAggregate[i]] |= 1u << i;
        }
    return agaa_countedWork(count, samples.covered);
}
#endif

agaa_Means agaa_meansOf(uvec2 pixel, uint mask) {
    agaa_Means m = agaa_noMeans();
    float share = 1.0 / float(bitCount(mask));
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        agaa_fetchSample(pixel, uint(findLSB(rest)));
        agaa_addToMeans(m, share, agaa_sampleSurface());
        agaa_addCustom(m, share, agaa_fetchedCustom());
    }
    return m;
}

#if AGAA_LIT
agaa_Means agaa_litMeans(uvec2 pixel, uint mask, float scale) {
    agaa_Means m = agaa_noMeans();
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        agaa_fetchSample(pixel, i);
        agaa_addToMeans(m, scale * agaa_lightOf(i), agaa_sampleSurface());
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
    agaa_groupTile();
    agaa_shadeTile();
    agaa_countEnd();
}
