// Shades one sample of each pixel, and counts how many the pixel's geometry calls for (Hollaender et al. 2013, sections 3 and
// 3.1).
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#define AGAA_COMPOSITE 0
#define AGAA_MAX_EVENTS 1u
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/lighting.glsl"
#include "passes/output.glsl"
#include "math/statistics.glsl"
#include "passes/owner_words.glsl"
#include "passes/stored_choice.glsl"
#include "passes/sample_visibility.glsl"
#include "passes/tile_pixels.glsl"
#include "passes/events.glsl"

shared uint agaa_represented[64]; // samples that each pixel's event stands for

float agaa_joinedCount = 0.0; // of the pixel of this lane

// Section 3.1 as printed: the variance of depth, and the cone around the mean normal.
float agaa_printedCount(uvec2 pixel, uint covered) {
    vec3 sum = vec3(0.0);
    agaa_Moments depth = agaa_momentsInit(uintBitsToFloat(agaa_sampleFeatures[findLSB(covered)].x));
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        agaa_momentsAdd(depth, uintBitsToFloat(agaa_sampleFeatures[i].x));
        sum += agaa_featuresOf(pixel, i).normal;
    }
    float size = dot(sum, sum);
    vec3 mean = size > 0.0 ? sum * inversesqrt(size) : vec3(0.0);
    float smallest = 1.0;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u)
        smallest = min(smallest, abs(dot(mean, agaa_featuresOf(pixel, uint(findLSB(rest))).normal)));
    return max(agaa_momentsVariance(depth) * uintBitsToFloat(AGAA_DEPTH_SCALE),
               agaa_normalMetric(smallest) * uintBitsToFloat(AGAA_NORMAL_SCALE));
}

// 0: as many as differ.
uint agaa_countByGeometry(uvec2 pixel, uint covered) {
    uint most = uint(bitCount(covered));
    if (!agaa_isAdaptive(agaa_byGeometry))
        return agaa_isAdaptive(agaa_byShading) ? 1u : most;
    if (agaa_isAdaptive(agaa_printedMetric))
        return agaa_wholeCount(agaa_printedCount(pixel, covered), 1u, most);
    return 0u;
}

// The mean of counts over frames, or this frame's where that is more.
uint agaa_remember(uvec2 pixel, uint count) {
    float mean = uintBitsToFloat(agaa_choices.words[agaa_meanAt(pixel)]);
    mean = agaa_meanOfCounts(mean, count, uintBitsToFloat(AGAA_COUNT_MEMORY));
    agaa_choices.words[agaa_meanAt(pixel)] = floatBitsToUint(mean);
    return agaa_wholeCount(mean - 0.5, count, AGAA_SAMPLES);
}

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    const uint lane = gl_LocalInvocationIndex;
    uint covered = agaa_beginChoice(pixel);
    if (covered == 0u) {
        if (AGAA_COUNT_MEMORY != 0u)
            agaa_remember(pixel, 0u);
        imageStore(agaa_output, ivec2(pixel), vec4(0.0));
        return agaa_pixelWork(0u, 0u, 0u);
    }
    uint first = agaa_firstInOrder(covered);
    uint count = agaa_countByGeometry(pixel, covered);
    float left;
    uint chosen = agaa_chooseMore(pixel, covered, 1u << first, count, count != 0u ? count : AGAA_SAMPLES, left);
    if (AGAA_COUNT_MEMORY != 0u) {
        uint mean = agaa_remember(pixel, uint(bitCount(chosen)));
        chosen = agaa_chooseMore(pixel, covered, chosen, mean, mean, left);
    }
    agaa_joinedCount = agaa_joinCount(uint(bitCount(chosen)), left);
    agaa_storeChoice(pixel, covered);
    agaa_represented[lane] = agaa_samplesOf(covered, first);
    return agaa_pixelWork(1u << first, 0u, 1u);
}

vec3 agaa_shadeEvent(uint lane, uint i) {
    uvec2 pixel = agaa_pixelOf(lane);
    agaa_findVisibility(pixel, agaa_isAdaptive(agaa_equalWeights) ? 1u << i : agaa_represented[lane]);
    agaa_fetchEvent(pixel, i, agaa_represented[lane]);
    return agaa_lightSurface(agaa_sampleSurface(), agaa_samplePosition(pixel, i));
}

void main() {
    agaa_countBegin();
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    agaa_PixelWork work = agaa_pixelWork(0u, 0u, 0u);
    if (all(lessThan(pixel, agaa_frame.size.xy)))
        work = agaa_workOf(pixel);
    vec3 color = agaa_shadeWork(work);
    if (work.covered != 0u)
        imageStore(agaa_output, ivec2(pixel), vec4(min(color, vec3(65504.0)), agaa_joinedCount));
    agaa_countEnd();
}
