// Shades one sample of each pixel and compares the others with it (Hollaender et al. 2013, sections 3 and 3.1).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/subgroup_extensions.glsl"
#if AGAA_SAMPLE_LANES
layout(local_size_x = 64) in; // full subgroups
#else
layout(local_size_x = 8, local_size_y = 8) in;
#endif
#define AGAA_MAX_EVENTS 1u
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "math/statistics.glsl"
#include "adaptive/sample_features.glsl"
#include "adaptive/pixel_list.glsl"
#include "gbuffer/sample_visibility.glsl"
#include "common/tile_pixels.glsl"
#include "common/events.glsl"

shared uint agaa_represented[64]; // mask of the samples whose shadows the event of each pixel has

// The pixel's samples in comparison with the first.
struct agaa_Comparison {
    uint covered; // samples with geometry
    uint alike;   // those that do not differ enough to be shaded
    uint first;
    float most; // the largest difference
};

#if !AGAA_SAMPLE_LANES
agaa_Comparison agaa_compareSamples(uvec2 pixel) {
    agaa_beginSamples(pixel);
    agaa_Comparison c = agaa_Comparison(0u, 0u, 0u, 0.0);
    uint k = 0u;
    do
        c.covered |= agaa_isCovered(pixel, k) ? 1u << k : 0u;
    while (++k < agaa_sampleCount());
    if (c.covered == 0u)
        return c;
    c.first = agaa_firstInOrder(c.covered);
    agaa_Features f;
    agaa_readFeatures(pixel, c.first, f);
    for (uint rest = c.covered & ~(1u << c.first); rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        agaa_Features own;
        agaa_readFeatures(pixel, i, own);
        float d = agaa_differenceOf(f, own);
        c.alike |= agaa_callsForSample(d) ? 0u : 1u << i;
        c.most = max(c.most, d);
    }
    c.alike |= 1u << c.first;
    return c;
}
#endif

// Returns the number of samples by the metric as printed by Hollaender et al. 2013, section 3.1: the variance of depth,
// and the cone around the mean normal.
// With AGAA_ADAPTIVE_BACKGROUND, samples without geometry count, too: at the depth of the far plane, and with a normal
// that is perpendicular to all others.
// covered   Mask of samples with geometry, one or more.
float agaa_printedCount(uvec2 pixel, uint covered) {
    vec3 sum = vec3(0.0);
    agaa_Moments depth = agaa_momentsInit(agaa_depthOf(pixel, uint(findLSB(covered))));
    agaa_Features f;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        agaa_readFeatures(pixel, i, f);
        agaa_momentsAdd(depth, agaa_depthOf(pixel, i));
        sum += f.normal;
    }
    uint background = AGAA_SAMPLES - uint(bitCount(covered));
    if (!agaa_isAdaptive(AGAA_ADAPTIVE_BACKGROUND))
        background = 0u;
    for (uint i = 0u; i < background; ++i)
        agaa_momentsAdd(depth, float(AGAA_FAR_DEPTH));
    float size = dot(sum, sum);
    vec3 mean = size > 0.0 ? sum * inversesqrt(size) : vec3(0.0);
    float smallest = background != 0u ? 0.0 : 1.0;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        agaa_readFeatures(pixel, uint(findLSB(rest)), f);
        smallest = min(smallest, abs(dot(mean, f.normal)));
    }
    return max(agaa_momentsVariance(depth) * uintBitsToFloat(AGAA_DEPTH_SCALE),
               agaa_normalMetric(smallest) * uintBitsToFloat(AGAA_NORMAL_SCALE));
}

// Returns the number of samples by geometry; 2 stands for several if it is not known yet.
uint agaa_countByGeometry(uvec2 pixel, agaa_Comparison c) {
    uint most = uint(bitCount(c.covered));
    if (!agaa_isAdaptive(AGAA_ADAPTIVE_GEOMETRY))
        return agaa_isAdaptive(AGAA_ADAPTIVE_SHADING) ? 1u : most;
    if (agaa_isAdaptive(AGAA_ADAPTIVE_PRINTED_METRIC))
        return agaa_wholeCount(agaa_printedCount(pixel, c.covered), 1u, most);
    return agaa_callsForSample(c.most) ? 2u : 1u;
}

#if AGAA_SAMPLE_LANES
shared agaa_Comparison agaa_comparisons[64]; // of each lane's pixel
shared uint agaa_sampleCounts[64];

// Compares the samples of all pixels of the tile. All lanes must call it.
void agaa_compareTile() {
    for (uint iteration = 0u; iteration < agaa_pixelLanes; ++iteration) {
        const uint lane = agaa_lanePixel(iteration);
        const uvec2 pixel = agaa_pixelOf(lane);
        agaa_LaneFeatures s = agaa_loadLaneFeatures(pixel);
        agaa_Comparison c = agaa_Comparison(s.covered, agaa_alikeSamples(s), s.first,
                                            agaa_maxOfPixel(s.isCovered ? max(s.difference, 0.0) : 0.0));
        if (agaa_laneSample() == 0u) {
            agaa_comparisons[lane] = c;
            agaa_sampleCounts[lane] = c.covered != 0u ? agaa_countByGeometry(pixel, c) : 0u;
        }
    }
    barrier();
}
#endif

agaa_PixelWork agaa_workOf(uvec2 pixel, agaa_Comparison c, uint count) {
    agaa_choices.words[agaa_choiceAt(pixel)] =
        agaa_packCount(uint(bitCount(c.covered)), count, agaa_shareOfLimit(c.most));
    if (c.covered == 0u) {
        imageStore(agaa_output, ivec2(pixel), vec4(agaa_backgroundPixel(ivec2(pixel)).rgb, 0.0));
        return agaa_pixelWork(0u, 0u, 0u);
    }
    agaa_represented[gl_LocalInvocationIndex] = agaa_samplesOfFirst(c.first, c.alike, c.covered);
    return agaa_pixelWork(1u << c.first, 0u, 1u);
}

vec3 agaa_shadeEvent(uint lane, uint i) {
    uvec2 pixel = agaa_pixelOf(lane);
    agaa_findVisibility(pixel, agaa_isAdaptive(AGAA_ADAPTIVE_EQUAL_WEIGHTS) ? 1u << i : agaa_represented[lane]);
    if (!agaa_isAdaptive(AGAA_ADAPTIVE_EQUAL_WEIGHTS))
        agaa_findSpread(pixel, i, agaa_represented[lane]);
    agaa_fetchEvent(pixel, i, agaa_represented[lane]);
    agaa_setEventCustom(agaa_fetchedCustom());
    return agaa_lightSurface(agaa_sampleSurface(), agaa_samplePosition(pixel, i));
}

void main() {
    agaa_countBegin();
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    agaa_PixelWork work = agaa_pixelWork(0u, 0u, 0u);
    uint count = 0u;
#if AGAA_SAMPLE_LANES
    agaa_compareTile();
#endif
    if (all(lessThan(pixel, agaa_frame.size))) {
#if AGAA_SAMPLE_LANES
        agaa_Comparison c = agaa_comparisons[gl_LocalInvocationIndex];
        count = agaa_sampleCounts[gl_LocalInvocationIndex];
#else
        agaa_Comparison c = agaa_compareSamples(pixel);
        count = c.covered != 0u ? agaa_countByGeometry(pixel, c) : 0u;
#endif
        work = agaa_workOf(pixel, c, count);
    }
    if (AGAA_COUNTS_FOUND == AGAA_FOUND_BETWEEN)
        agaa_listPixel(pixel, count > 1u, AGAA_COMPLEX_PIXELS_AT);
    vec3 color = agaa_shadeWork(work);
    if (work.covered != 0u)
        imageStore(agaa_output, ivec2(pixel), vec4(agaa_representableColor(color), 1.0));
    agaa_countEnd();
}
