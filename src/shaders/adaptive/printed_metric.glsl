// Numbers of samples as printed by Hollaender et al. 2013, section 3.1: the variance of depth, and the cone around the mean
// normal.
#ifndef AGAA_PRINTED_METRIC_GLSL
#define AGAA_PRINTED_METRIC_GLSL
#include "math/statistics.glsl"
#include "adaptive/sample_features.glsl"

// covered: samples that show geometry, one or more.
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
    float size = dot(sum, sum);
    vec3 mean = size > 0.0 ? sum * inversesqrt(size) : vec3(0.0);
    float smallest = 1.0;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        agaa_readFeatures(pixel, uint(findLSB(rest)), f);
        smallest = min(smallest, abs(dot(mean, f.normal)));
    }
    return max(agaa_momentsVariance(depth) * uintBitsToFloat(AGAA_DEPTH_SCALE),
               agaa_normalMetric(smallest) * uintBitsToFloat(AGAA_NORMAL_SCALE));
}
#endif
