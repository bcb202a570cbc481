// Shading of every covered sample of a multisampled G-buffer.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_SET 0
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/lighting.glsl"
#include "passes/output.glsl"
#include "math/encoding.glsl"

layout(set = AGAA_SET, binding = 3) uniform AGAA_TARGET_TEXTURE agaa_depth;
layout(set = AGAA_SET, binding = 4) uniform AGAA_TARGET_TEXTURE agaa_gbuffer0;
layout(set = AGAA_SET, binding = 5) uniform AGAA_TARGET_TEXTURE agaa_gbuffer1;
layout(set = AGAA_SET, binding = 6) uniform AGAA_TARGET_TEXTURE agaa_gbuffer2;
layout(set = AGAA_SET, binding = 7) uniform AGAA_TARGET_TEXTURE agaa_gbuffer3;

vec4 agaa_texels[4];

// Fields are constants, so that each call folds to one component of one texel.
float agaa_channel(uint field) { return agaa_texels[field & 0xFFu][field >> 8u & 0xFFu]; }

void agaa_fetchTexels(uvec2 pixel, uint i) {
    agaa_texels[0] = AGAA_FETCH(agaa_gbuffer0, pixel, i);
    agaa_texels[1] = AGAA_FETCH(agaa_gbuffer1, pixel, i);
    agaa_texels[2] = AGAA_FETCH(agaa_gbuffer2, pixel, i);
    agaa_texels[3] = AGAA_FETCH(agaa_gbuffer3, pixel, i);
}

agaa_Surface agaa_sampleSurface() {
    agaa_Surface s;
    s.diffuse = vec3(agaa_channel(AGAA_FIELD_DIFFUSE_R), agaa_channel(AGAA_FIELD_DIFFUSE_G),
                     agaa_channel(AGAA_FIELD_DIFFUSE_B));
    s.normal = agaa_decodeOct(
        vec2(agaa_channel(AGAA_FIELD_NORMAL_X), agaa_channel(AGAA_FIELD_NORMAL_Y)),
        AGAA_FIELD_NORMAL_X >> 16);
    s.meanLength = 1.0;
    s.specular = vec3(0.0);
    s.alpha2 = 1.0;
    if (AGAA_HAS_SPECULAR != 0u) {
        s.specular = vec3(agaa_channel(AGAA_FIELD_SPECULAR_R), agaa_channel(AGAA_FIELD_SPECULAR_G),
                          agaa_channel(AGAA_FIELD_SPECULAR_B));
        if (AGAA_FIELD_ROUGHNESS >> 16 != 0u)
            s.alpha2 = agaa_channel(AGAA_FIELD_ROUGHNESS);
    }
    s.emissive = vec3(0.0);
    if (AGAA_EMISSIVE_CHANNELS == 3u)
        s.emissive = agaa_frame.ambient.w * vec3(agaa_channel(AGAA_FIELD_EMISSIVE_R),
                                                 agaa_channel(AGAA_FIELD_EMISSIVE_G),
                                                 agaa_channel(AGAA_FIELD_EMISSIVE_B));
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        s.emissive = agaa_frame.ambient.w * agaa_channel(AGAA_FIELD_EMISSIVE_R) * s.diffuse;
    return s;
}

void agaa_shadePixel(uvec2 pixel) {
    vec3 color = vec3(0.0);
    uint covered = 0u;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i) {
        agaa_fetchTexels(pixel, i);
        if (agaa_channel(AGAA_FIELD_NORMAL_X) == 0.0)
            continue; // no geometry
        ++covered;
        vec3 position = agaa_toShadingSpace(
            agaa_sampleViewPosition(pixel, i, AGAA_FETCH(agaa_depth, pixel, i).x));
#if AGAA_SHADOWS
        for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
            agaa_visibility[map] = agaa_shadowTap(map, position);
        agaa_count(AGAA_COUNT_SHADOW_TAPS, AGAA_SHADOW_MAPS);
#endif
        color += agaa_lightSurface(agaa_sampleSurface(), position);
    }
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_count(AGAA_COUNT_WRITTEN, covered);
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
