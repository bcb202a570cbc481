// Shading of every covered sample of a multisampled G-buffer.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/lighting.glsl"
#include "passes/output.glsl"
#include "passes/gbuffer.glsl"

layout(AGAA_AT_DEPTH) uniform AGAA_TARGET_TEXTURE agaa_depth;

void agaa_shadePixel(uvec2 pixel) {
    vec3 color = vec3(0.0);
    uint covered = 0u;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i) {
        if (!agaa_fetchSample(pixel, i))
            continue;
        ++covered;
        vec3 position = agaa_toShadingSpace(
            agaa_sampleViewPosition(pixel, i, AGAA_FETCH(agaa_depth, pixel, i).x));
#if AGAA_SHADOWS
        for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
            agaa_visibility[map] = agaa_shadowTap(map, position);
#endif
        color += agaa_lightSurface(agaa_sampleSurface(), position);
    }
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_count(AGAA_COUNT_EVENTS, covered);
    agaa_count(AGAA_COUNT_PIXELS, covered != 0u ? 1u : 0u);
    agaa_writeOutput(pixel, color / float(AGAA_SAMPLES), covered);
}

void main() {
    agaa_countBegin();
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (all(lessThan(pixel, agaa_frame.size.xy)))
        agaa_shadePixel(pixel);
    agaa_countEnd();
}
