// Estimates the light of each sample of pixels with several, without shadows. Samples that differ by it are shaded.
// Source: Hollaender et al. 2013, section 6, metrics that are aware of lights (future work).
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#define AGAA_SHADOWS 0
#define AGAA_COUNTING 0
#define AGAA_ESTIMATES_LIGHT
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "math/display.glsl"
#include "adaptive/sample_features.glsl"
#include "common/tile_pixels.glsl"

// Returns whether point or spot lights may reach the pixel. Where they do not, the light of samples that do not shine
// differs only by normals and colours, which are compared on their own.
bool agaa_hasLocalLight() {
    bool any = false;
    if (AGAA_LIGHT_WORDS == 0u) {
        for (uint i = 0u; i < agaa_lightBuffer.shadows[0].lightCount; ++i)
            any = any || agaa_lightBuffer.lights[i].type != AGAA_LIGHT_DIRECTIONAL;
    } else {
        for (uint word = 0u; word < AGAA_LIGHT_WORDS; ++word)
            for (uint left = agaa_lightWord(word); left != 0u; left &= left - 1u)
                any = any || agaa_lightBuffer.lights[32u * word + uint(findLSB(left))].type != AGAA_LIGHT_DIRECTIONAL;
    }
    return any;
}

// Returns the luma of the light of a sample as displayed, [0, 1].
float agaa_estimateLight(agaa_Features f) {
    agaa_Surface s = agaa_Surface(f.diffuseAlpha.xyz, f.specular, vec3(0.0), f.normal, 1.0,
                                  f.diffuseAlpha.w * f.diffuseAlpha.w, 0.0, vec3(0.0));
    vec3 toEye = agaa_toEye(f.position);
    vec3 sum = vec3(0.0);
    if (AGAA_LIGHT_WORDS == 0u) {
        for (uint i = 0u; i < agaa_lightBuffer.shadows[0].lightCount; ++i)
            sum += agaa_oneLight(s, f.position, toEye, i);
    } else {
        for (uint word = 0u; word < AGAA_LIGHT_WORDS; ++word)
            for (uint left = agaa_lightWord(word); left != 0u; left &= left - 1u)
                sum += agaa_oneLight(s, f.position, toEye, 32u * word + uint(findLSB(left)));
    }
    uint bad = 0u;
    return agaa_displayLuma(agaa_sanitise3(sum, 0.0, AGAA_MAX_HALF, bad));
}

void agaa_estimatePixel(uvec2 pixel) {
    uint covered = 0u;
    uint i = 0u;
    do
        covered |= agaa_isCovered(pixel, i) ? 1u << i : 0u;
    while (++i < agaa_sampleCount());
    if (bitCount(covered) < 2)
        return;
    agaa_lightPixel(pixel);
    const bool mayDiffer = AGAA_HAS_SPECULAR != 0u || agaa_hasLocalLight();
    if (mayDiffer)
        agaa_beginSamples(pixel);
    for (uint map = 0u; map < AGAA_MAX_SHADOW_MAPS; ++map)
        agaa_visibility[map] = 1.0;
    uint word = 0u;
    for (uint k = 0u; k < AGAA_SAMPLES; ++k) {
        agaa_Features f;
        if (mayDiffer && (covered >> k & 1u) != 0u && agaa_readFeatures(pixel, k, f))
            word |= min(uint(agaa_estimateLight(f) * 255.0 + 0.5), 255u) << (8u * (k & 3u));
        if ((k & 3u) == 3u || k + 1u == AGAA_SAMPLES) {
            agaa_choices.words[agaa_lightAt(pixel, k >> 2u)] = word;
            word = 0u;
        }
    }
}

void main() {
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    if (all(lessThan(pixel, agaa_frame.size)))
        agaa_estimatePixel(pixel);
}
