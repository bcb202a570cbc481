// Shades once per aggregate, weighted by its share of the pixel's samples (AGAA section 3.5), or once per surface,
// which one of its samples represents (SBAA).
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "aggregate/aggregate_lighting.glsl"
#include "math/encoding.glsl"
#include "math/sbaa_records.glsl"
#include "tables/layouts.inc"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "common/tile.glsl"

#if !defined(AGAA_HOST_GBUFFER) && !AGAA_EXPANDED
#define AGAA_READS_NORMALS
#include "aggregate/prepass_normals.glsl"
#endif

#if AGAA_COUNTING
#ifdef AGAA_HOST_GBUFFER
bool agaa_isVisible(uvec2 pixel, uint i) { return agaa_hostShows(pixel, i); }
#elif AGAA_EXPANDED
bool agaa_isVisible(uvec2 pixel, uint i) { return agaa_visibleId(pixel, i) != 0u; }
#else
bool agaa_isVisible(uvec2 pixel, uint i) {
    vec4 texel = AGAA_FETCH(agaa_normals, pixel, i);
    return AGAA_COVERAGE_COMPONENT != AGAA_ANY_COMPONENT ? texel[AGAA_COVERAGE_COMPONENT & 3u] > 0.0
                                                        : texel != vec4(0.0);
}
#endif
#endif
#define AGAA_IMAGE_WIDTH agaa_frame.size.x
#define AGAA_EMISSIVE_RANGE agaa_frame.emissiveRange
#include "aggregate/stored_means.glsl"
#include "math/normal_moments.glsl"
#ifdef AGAA_BLENDED_TARGETS // a plan with aggregates in attachments has it, and compiles the pass with the view
#include "aggregate/blended_aggregate.glsl"
#else
layout(std430, AGAA_BINDING_AGGREGATES) readonly buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;
#define AGAA_AGGREGATE_WORD(i) agaa_aggregates.words[i]
#include "aggregate/stored_aggregate.glsl"
#include "aggregate/stored_depth.glsl"
#endif

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    agaa_PixelWork work = agaa_pixelWork(0u, 0u, 0u);
    uint coveredMask = 0u;
    uint twice = 0u;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a) {
        agaa_selectAggregate(pixel, a);
        uint mask = agaa_coverage();
        work.events[0] |= mask != 0u ? 1u << a : 0u;
        work.covered += uint(bitCount(mask));
        twice |= coveredMask & mask;
        coveredMask |= mask;
    }
#if AGAA_COUNTING
    uint visible = 0u;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        if (agaa_isVisible(pixel, i))
            visible |= 1u << i;
    uint once = uint(bitCount(visible & coveredMask));
    agaa_count(AGAA_COUNT_VISIBLE, uint(bitCount(visible)));
    agaa_count(AGAA_COUNT_ONCE, once);
    agaa_count(AGAA_COUNT_UNCOVERED, uint(bitCount(visible & ~coveredMask)));
    agaa_count(AGAA_COUNT_OVERLAPPING, work.covered - once);
    uint uncovered = visible & ~coveredMask;
    uint overlapping = twice | (coveredMask & ~visible);
    if ((uncovered | overlapping) != 0u)
        agaa_reportPixel(pixel, visible, uncovered, overlapping);
    agaa_countEvents(agaa_eventsOf(work));
    agaa_count(AGAA_COUNT_AGGREGATES, agaa_eventsOf(work));
    agaa_count(AGAA_COUNT_PIXELS, work.events[0] != 0u ? 1u : 0u);
#endif
    return work;
}

// normals   The samples whose mean is the normal.
agaa_Means agaa_meansOfAggregate(uvec2 pixel, uint normals) {
    agaa_Means means = agaa_meansOfStored(agaa_storedMeans());
    if (AGAA_SPREAD_WORDS != 0u)
        means.moments = agaa_storedMoments();
#ifdef AGAA_BLENDED_TARGETS
    means.lengthBound = agaa_summedLengthBound();
#endif
#ifdef AGAA_READS_NORMALS
    if (AGAA_PREPASS_NORMALS != 0u) {
        means.normal = agaa_meanPrepassNormal(pixel, normals);
        means.lengthBound = agaa_hemiOct8LengthBound();
    }
#endif
    return means;
}

vec3 agaa_shadeEvent(uint lane, uint a) {
    uvec2 pixel = agaa_pixelOf(lane);
    agaa_selectAggregate(pixel, a);
    uint mask = agaa_coverage();
    uint normals = mask;
    agaa_aggregateSamples = uint(bitCount(mask));
    vec3 position;
#ifndef AGAA_BLENDED_TARGETS
    if (AGAA_DEPTH_WORDS != 0u)
        position = agaa_locateByMoments(pixel, mask);
    else
#endif
        position = agaa_locateAggregate(pixel, mask);
#if AGAA_REPRESENTED
    uint shaded = agaa_recordShaded(agaa_record(), AGAA_SAMPLES);
    normals = 1u << shaded;
    vec3 mean = position;
    position = agaa_toShadingSpace(
        agaa_sampleViewPosition(pixel, shaded, agaa_depthOf(pixel, shaded)));
    agaa_setSpread(agaa_positionSpread + dot(position - mean, position - mean), position);
    agaa_addToFootprint(1.0, position - mean);
#endif
    return agaa_shadeMeans(pixel, position, a, mask, agaa_meansOfAggregate(pixel, normals),
                           AGAA_FOLDED_ROUGHNESS != 0u);
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
