// Shadows of a shading event at the samples of a G-buffer that it represents. Needs common/target.glsl and
// AGAA_SHADOWS.
#ifndef AGAA_SAMPLE_VISIBILITY_GLSL
#define AGAA_SAMPLE_VISIBILITY_GLSL
#include "aggregate/shadow_taps.glsl"
#include "common/lighting.glsl"
#include "common/sample_depth.glsl"

vec3 agaa_samplePosition(uvec2 pixel, uint i) {
    return agaa_toShadingSpace(agaa_sampleViewPosition(pixel, i, agaa_depthOf(pixel, i)));
}

// Finds the spread of the samples that sample i represents, which is 0 for one sample.
// mask   The represented samples.
void agaa_findSpread(uvec2 pixel, uint i, uint mask) {
    vec3 position = agaa_samplePosition(pixel, i);
    float sum = 0.0;
    float share = 1.0 / float(max(bitCount(mask), 1));
    agaa_beginFootprint();
    for (uint rest = mask & ~(1u << i); rest != 0u; rest &= rest - 1u) {
        vec3 away = agaa_samplePosition(pixel, uint(findLSB(rest))) - position;
        sum += dot(away, away);
        agaa_addToFootprint(share, away);
    }
    agaa_setSpread(sum * share, position);
}

// Finds the footprint of samples around their mean. Returns the mean.
vec3 agaa_findFootprint(uvec2 pixel, uint mask) {
    vec3 first = agaa_samplePosition(pixel, uint(findLSB(mask)));
    vec3 mean = vec3(0.0);
    agaa_beginFootprint();
    for (uint rest = mask & (mask - 1u); rest != 0u; rest &= rest - 1u) {
        vec3 away = agaa_samplePosition(pixel, uint(findLSB(rest))) - first;
        agaa_addToFootprint(1.0, away);
        mean += away;
    }
    float count = float(bitCount(mask));
    mean /= count;
    agaa_footprint = agaa_momentsAroundMean(agaa_footprint, count, mean);
    return first + mean;
}

// Finds the visibility of all shadowed lights. Shadows end within surfaces, so they are looked up at each of the
// samples that are shaded once, up to AGAA_SHADOW_TAPS.
// mask   One or more samples with geometry.
void agaa_findVisibility(uvec2 pixel, uint mask) {
    agaa_lightPixel(pixel);
    agaa_setEvent(pixel, uvec4(mask, 0u, 0u, 0u));
#if AGAA_SHADOWS
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        agaa_visibility[map] = 0.0;
    uint count = uint(bitCount(mask));
    uint taps = AGAA_SHADOW_FILTER != AGAA_SHADOW_AT_MEAN ? min(count, AGAA_SHADOW_TAPS) : 1u;
    agaa_Choice choice = agaa_chooseFrom(mask, taps);
    uint j = 0u;
    do
        agaa_addTaps(agaa_samplePosition(pixel, agaa_nextSample(choice, j)));
    while (++j < taps);
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
        agaa_visibility[map] /= float(taps);
#if AGAA_HOST_FOOTPRINTS
    agaa_lookUpFootprint(agaa_findFootprint(pixel, mask));
#endif
#endif
}
#endif
