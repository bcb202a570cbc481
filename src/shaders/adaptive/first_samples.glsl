// The image of first samples, and the samples that its differences demand (Hollaender et al. 2013, section 3.1). Needs
// common/frame.glsl.
#ifndef AGAA_FIRST_SAMPLES_GLSL
#define AGAA_FIRST_SAMPLES_GLSL
#include "math/adaptive.glsl"
#include "math/display.glsl"
#include "adaptive/adaptive_flags.glsl"
#include "adaptive/stored_choice.glsl"

// Radiance. Pixels without geometry have the background, with alpha 0.
layout(AGAA_BINDING_FIRST_SAMPLES) uniform sampler2D agaa_firstSamples;

vec4 agaa_firstSample(ivec2 pixel) { return texelFetch(agaa_firstSamples, pixel, 0); }

// Returns tone-mapped colour in [0, 1], so that one bright pixel raises the counts of its neighbours no more than an
// edge. The printed metric compares luma, in which colours may be equal.
vec3 agaa_firstColor(ivec2 pixel) {
    vec3 color = agaa_firstSample(clamp(pixel, ivec2(0), ivec2(agaa_frame.size) - 1)).rgb;
    return agaa_isAdaptive(AGAA_ADAPTIVE_PRINTED_METRIC) ? vec3(agaa_displayLuma(color)) : agaa_displayed(color);
}

float agaa_countByRange(float lowest, float highest) {
    return agaa_shadingCount(lowest, highest, uintBitsToFloat(AGAA_SHADING_THRESHOLD),
                             uintBitsToFloat(AGAA_SHADING_MINIMUM), uintBitsToFloat(AGAA_SHADING_SCALE));
}

// Returns the number of samples k_s, a real number.
float agaa_countByShading(uvec2 pixel) {
    if (!agaa_isAdaptive(AGAA_ADAPTIVE_SHADING))
        return 0.0;
    vec3 lowest = agaa_firstColor(ivec2(pixel));
    vec3 highest = lowest;
    for (int side = -1; side <= 1; side += 2) {
        vec3 x = agaa_firstColor(ivec2(pixel) + ivec2(side, 0));
        vec3 y = agaa_firstColor(ivec2(pixel) + ivec2(0, side));
        lowest = min(lowest, min(x, y));
        highest = max(highest, max(x, y));
    }
    return max(agaa_countByRange(lowest.x, highest.x),
               max(agaa_countByRange(lowest.y, highest.y), agaa_countByRange(lowest.z, highest.z)));
}

// Returns the number of samples that shading demands beyond those of geometry. The printed metric takes the larger
// count. The other one scales the count by `left`, because lights show little difference between similar samples, and
// shadows are looked up at all samples anyway.
// byShading   agaa_countByShading().
// left        Difference of the other samples from the chosen ones, [0, 1].
float agaa_furtherByShading(float byShading, uint count, float left) {
    return agaa_isAdaptive(AGAA_ADAPTIVE_PRINTED_METRIC) ? max(byShading - float(count), 0.0) : byShading * left;
}

// Returns the whole number of samples with these further ones.
uint agaa_withFurther(uint count, float further) {
    float rounding = agaa_isAdaptive(AGAA_ADAPTIVE_PRINTED_METRIC) ? 0.0 : 0.5;
    return agaa_wholeCount(float(count) - rounding + further, count, AGAA_SAMPLES);
}

uint agaa_countBoth(float byShading, uint count, float left) {
    float further = agaa_furtherByShading(byShading, count, left);
    return agaa_hasRoomFor(further) ? agaa_withFurther(count, further) : count;
}
#endif
