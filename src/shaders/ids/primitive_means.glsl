// Means over the samples of primitives, which have one material each in a pixel. Needs what
// aggregate/aggregate_lighting.glsl needs.
#ifndef AGAA_PRIMITIVE_MEANS_GLSL
#define AGAA_PRIMITIVE_MEANS_GLSL
#include "aggregate/aggregate_lighting.glsl"
#include "ids/fetched_means.glsl"
#include "ids/sample_ids.glsl"
#include "common/pixel_work.glsl"

float agaa_weightOf(uint i, bool isLit) {
#if AGAA_LIT
    if (isLit)
        return agaa_lightOf(i);
#endif
    return 1.0;
}

agaa_PositionSums agaa_positionSumsOf(uint samples, float scale, bool isLit) {
    agaa_PositionSums p = agaa_PositionSums(0.0, vec2(0.0), vec3(0.0));
    for (uint rest = samples; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        float weight = scale * agaa_weightOf(i, isLit);
        vec2 at = agaa_sampleLocation(i);
        p.weight += weight;
        p.sum += weight * at;
        p.products += weight * vec3(at * at, at.x * at.y);
    }
    return p;
}

// Adds these samples of a primitive to the means.
void agaa_addPrimitive(inout agaa_Means m, AgaaMaterial material, uint samples, float scale, bool isLit) {
    bool isCurved = agaa_isCurvedMaterial(material);
    agaa_PositionSums sums = agaa_positionSumsOf(isCurved || isLit ? samples : 0u, scale, isLit);
    float weight = isCurved || isLit ? sums.weight : scale * float(bitCount(samples));
    agaa_addFetched(m, material, weight, sums);
}

// Counts a pixel and returns its work.
// count       Number of the pixel's aggregates.
// uncovered   Samples with geometry that have no material.
agaa_PixelWork agaa_countedWork(uvec2 pixel, uint count, uint covered, uint uncovered) {
    uint samples = uint(bitCount(covered));
    agaa_count(AGAA_COUNT_VISIBLE, uint(bitCount(covered | uncovered)));
    agaa_count(AGAA_COUNT_ONCE, samples);
#if AGAA_COUNTING
    agaa_count(AGAA_COUNT_UNCOVERED, uint(bitCount(uncovered)));
    if (uncovered != 0u)
        agaa_reportPixel(pixel, covered | uncovered, uncovered, 0u);
#endif
    agaa_countEvents(count);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_pixelWork((1u << count) - 1u, 0u, samples);
}
#endif
