// The position of an aggregate and its shadow taps by stored moments of depth, in place of the depths of its samples
// (AGAA_MEASURE_STORED_DEPTH). Needs aggregate/aggregate_lighting.glsl and aggregate/stored_aggregate.glsl.
#ifndef AGAA_STORED_DEPTH_GLSL
#define AGAA_STORED_DEPTH_GLSL
#if !defined(AGAA_AGGREGATE_LIGHTING_GLSL) || !defined(AGAA_STORED_AGGREGATE_GLSL)
#error "stored_depth.glsl needs aggregate_lighting.glsl and stored_aggregate.glsl."
#endif
#include "math/depth_moments.glsl"

agaa_StoredDepth agaa_depthOfAggregate(uint count) {
    const uint at = agaa_base + AGAA_WORDS + AGAA_SPREAD_WORDS;
    uvec4 sums = uvec4(AGAA_AGGREGATE_WORD(at), AGAA_AGGREGATE_WORD(at + 1u), AGAA_AGGREGATE_WORD(at + 2u),
                       AGAA_AGGREGATE_WORD(at + 3u));
    return agaa_storedDepth(agaa_momentsOfCodes(sums, count), agaa_frame.projection22, agaa_frame.projection32,
                            agaa_isOrthographic());
}

// Does the same as agaa_locateAggregate(), without the correlation of depth with places in the pixel.
vec3 agaa_locateByMoments(uvec2 pixel, uint mask) {
    agaa_lightPixel(pixel);
    agaa_setEvent(pixel, uvec4(mask, 0u, 0u, 0u));
    const uint count = uint(bitCount(mask));
    const agaa_StoredDepth depth = agaa_depthOfAggregate(count);
    vec2 offset = vec2(0.0);
    for (uint rest = mask; rest != 0u; rest &= rest - 1u)
        offset += agaa_sampleLocation(uint(findLSB(rest)));
    offset /= float(count);
    const vec3 mean = agaa_viewPositionAtZ(pixel, offset, depth.mean);
    const vec3 along = agaa_viewPositionAtZ(pixel, offset, depth.mean - depth.deviation) - mean;
    agaa_beginFootprint();
    agaa_addToFootprint(float(count), along);
    float squares = float(count) * dot(along, along);
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        vec3 aside = agaa_viewPositionAtZ(pixel, agaa_sampleLocation(uint(findLSB(rest))), depth.mean) - mean;
        agaa_addToFootprint(1.0, aside);
        squares += dot(aside, aside);
    }
    agaa_endFootprintAroundMean(float(count), vec3(0.0));
    const vec3 position = agaa_toShadingSpace(mean);
#if AGAA_SHADOWS
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        agaa_visibility[map] = 0.0;
    const float sigma = AGAA_SHADOW_FILTER == AGAA_SHADOW_ALONG_DEPTH ? depth.deviation : 0.0;
    const uint taps = agaa_tapAlongDepth(mean, sigma, depth.farthest, depth.nearest);
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        agaa_visibility[map] /= float(taps);
    agaa_lookUpFootprint(position);
#endif
    agaa_setSpread(squares / float(count), position);
    return position;
}
#endif
