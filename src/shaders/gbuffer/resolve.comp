// Resolves a multisampled image: writes the mean of its samples over the background.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/output.glsl"

#include "common/sample_depth.glsl"
#include "gbuffer/forward_color.glsl"

// Alpha is 1 where a sample has geometry, else 0.
layout(AGAA_BINDING_COLOR) uniform AGAA_TARGET_TEXTURE agaa_color;

bool agaa_isAtFarPlane(uvec2 pixel, uint i) { return agaa_depthOf(pixel, i) == float(AGAA_FAR_DEPTH); }

#if AGAA_COUNTING
// Compares the alpha of the second geometry pass with the depth of the first.
void agaa_countSamples(uvec2 pixel, uint covered) {
    uint visible = 0u;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        visible |= agaa_isAtFarPlane(pixel, i) ? 0u : 1u << i;
    uint uncovered = visible & ~covered;
    uint overlapping = covered & ~visible;
    agaa_count(AGAA_COUNT_VISIBLE, uint(bitCount(visible)));
    agaa_count(AGAA_COUNT_ONCE, uint(bitCount(visible & covered)));
    agaa_count(AGAA_COUNT_UNCOVERED, uint(bitCount(uncovered)));
    agaa_count(AGAA_COUNT_OVERLAPPING, uint(bitCount(overlapping)));
    agaa_count(AGAA_COUNT_PIXELS, covered != 0u ? 1u : 0u);
    if ((uncovered | overlapping) != 0u)
        agaa_reportPixel(pixel, visible, uncovered, overlapping);
}
#else
void agaa_countSamples(uvec2 pixel, uint covered) {}
#endif

void agaa_resolvePixel(uvec2 pixel) {
    vec3 sum = vec3(0.0);
    uint covered = 0u;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i) {
        vec4 texel = AGAA_FETCH(agaa_color, pixel, i);
        bool isShown = texel.a > 0.0 && !(agaa_isMarkedFarPlane(texel.rgb) && agaa_isAtFarPlane(pixel, i));
        sum += isShown ? agaa_weightedLight(agaa_unmarkFarPlane(texel.rgb)) : vec3(0.0);
        covered |= isShown ? 1u << i : 0u;
    }
    agaa_countSamples(pixel, covered);
    agaa_writeOutput(pixel, sum / float(AGAA_SAMPLES), uint(bitCount(covered)));
}

void main() {
    agaa_countBegin();
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (all(lessThan(pixel, agaa_frame.size)))
        agaa_resolvePixel(pixel);
    agaa_countEnd();
}
