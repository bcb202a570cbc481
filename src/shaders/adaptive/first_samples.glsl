// The image of first samples, and the samples that its differences call for (Hollaender et al. 2013, section 3.1).
#ifndef AGAA_FIRST_SAMPLES_GLSL
#define AGAA_FIRST_SAMPLES_GLSL
#include "math/adaptive.glsl"
#include "common/display.glsl"
#include "adaptive/adaptive_flags.glsl"
#include "adaptive/stored_choice.glsl"

// Radiance; where the pixel shows no geometry, what is below, and alpha is 0.
layout(AGAA_BINDING_FIRST_SAMPLES) uniform sampler2D agaa_firstSamples;

vec4 agaa_firstSample(ivec2 pixel) { return texelFetch(agaa_firstSamples, pixel, 0); }

// Tone-mapped, in [0, 1]: one bright pixel raises the counts of its neighbours by no more than an edge does.
float agaa_firstLuma(ivec2 pixel) {
    ivec2 at = clamp(pixel, ivec2(0), ivec2(agaa_frame.size) - 1);
    return agaa_displayLuma(agaa_firstSample(at).rgb);
}

// k_s; a real number of samples.
float agaa_countByShading(uvec2 pixel) {
    if (!agaa_isAdaptive(AGAA_ADAPTIVE_SHADING))
        return 0.0;
    float lowest = agaa_firstLuma(ivec2(pixel));
    float highest = lowest;
    for (int side = -1; side <= 1; side += 2) {
        float x = agaa_firstLuma(ivec2(pixel) + ivec2(side, 0));
        float y = agaa_firstLuma(ivec2(pixel) + ivec2(0, side));
        lowest = min(lowest, min(x, y));
        highest = max(highest, max(x, y));
    }
    return agaa_shadingCount(lowest, highest, uintBitsToFloat(AGAA_SHADING_THRESHOLD), uintBitsToFloat(AGAA_SHADING_MINIMUM),
                             uintBitsToFloat(AGAA_SHADING_SCALE));
}

// How many samples more than geometry calls for. byShading: agaa_countByShading(); left: how far the others differ from these,
// [0, 1]. As printed, the larger count. Else as far as there is something for the lights to show differently: shadows are looked
// up at all samples anyway.
float agaa_furtherByShading(float byShading, uint count, float left) {
    return agaa_isAdaptive(AGAA_ADAPTIVE_PRINTED_METRIC) ? max(byShading - float(count), 0.0) : byShading * left;
}

// With as many further samples.
uint agaa_withFurther(uint count, float further) {
    float rounding = agaa_isAdaptive(AGAA_ADAPTIVE_PRINTED_METRIC) ? 0.0 : 0.5;
    return agaa_wholeCount(float(count) - rounding + further, count, AGAA_SAMPLES);
}

uint agaa_countBoth(float byShading, uint count, float left) {
    float further = agaa_furtherByShading(byShading, count, left);
    return agaa_hasRoomFor(further) ? agaa_withFurther(count, further) : count;
}
#endif
