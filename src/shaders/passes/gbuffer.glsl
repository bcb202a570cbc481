// Samples of a multisampled G-buffer: by the layout, where its attachments are and what their channels hold; or by
// a function of the host's.
#ifndef AGAA_GBUFFER_GLSL
#define AGAA_GBUFFER_GLSL
#include "math/encoding.glsl"
#include "math/light.glsl"
#include "passes/host_samples.glsl"

#ifdef AGAA_HOST_GBUFFER
AgaaMaterial agaa_fetched; // of the sample fetched last

bool agaa_fetchSample(uvec2 pixel, uint i) {
    float depth;
    return agaa_readHost(pixel, i, depth, agaa_fetched);
}

bool agaa_isCovered(uvec2 pixel, uint i) { return agaa_hostShows(pixel, i); }

vec2 agaa_normalCode() { return agaa_encodeOct(agaa_fetched.normal, AGAA_SOURCE_NORMAL_X >> 16); }
vec3 agaa_fetchedNormal() { return agaa_fetched.normal; }
vec3 agaa_fetchedDiffuse() { return agaa_fetched.diffuse; }
vec3 agaa_fetchedSpecular() { return agaa_fetched.specular; }
float agaa_fetchedAlpha2() { return agaa_fetched.alpha2; }

vec3 agaa_storedEmissive() {
    vec3 e = agaa_fetched.emissive / agaa_frame.ambient.w;
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        return vec3(agaa_emissiveFactor(agaa_fetched.diffuse, e));
    return AGAA_EMISSIVE_CHANNELS == 3u ? e : vec3(0.0);
}
#else
layout(AGAA_AT_SURFACE0) uniform AGAA_TARGET_TEXTURE agaa_gbuffer0;
layout(AGAA_AT_SURFACE1) uniform AGAA_TARGET_TEXTURE agaa_gbuffer1;
layout(AGAA_AT_SURFACE2) uniform AGAA_TARGET_TEXTURE agaa_gbuffer2;
layout(AGAA_AT_SURFACE3) uniform AGAA_TARGET_TEXTURE agaa_gbuffer3;

vec4 agaa_texels[4];

// Fields are constants, so that each call folds to one component of one texel.
float agaa_channel(uint field) { return agaa_texels[field & 0xFFu][field >> 8u & 0xFFu]; }

vec3 agaa_channel3(uint x, uint y, uint z) {
    return vec3(agaa_channel(x), agaa_channel(y), agaa_channel(z));
}

// False where the sample shows no geometry.
bool agaa_fetchSample(uvec2 pixel, uint i) {
    agaa_texels[0] = AGAA_FETCH(agaa_gbuffer0, pixel, i);
    agaa_texels[1] = AGAA_FETCH(agaa_gbuffer1, pixel, i);
    agaa_texels[2] = AGAA_FETCH(agaa_gbuffer2, pixel, i);
    agaa_texels[3] = AGAA_FETCH(agaa_gbuffer3, pixel, i);
    return agaa_channel(AGAA_SOURCE_NORMAL_X) != 0.0;
}

// As agaa_fetchSample(), without the fetching of what is not asked for.
bool agaa_isCovered(uvec2 pixel, uint i) {
    const uint attachment = AGAA_SOURCE_NORMAL_X & 0xFFu;
    vec4 texel = attachment == 0u   ? AGAA_FETCH(agaa_gbuffer0, pixel, i)
                 : attachment == 1u ? AGAA_FETCH(agaa_gbuffer1, pixel, i)
                 : attachment == 2u ? AGAA_FETCH(agaa_gbuffer2, pixel, i)
                                    : AGAA_FETCH(agaa_gbuffer3, pixel, i);
    return texel[AGAA_SOURCE_NORMAL_X >> 8u & 0xFFu] != 0.0;
}

vec2 agaa_normalCode() {
    return vec2(agaa_channel(AGAA_SOURCE_NORMAL_X), agaa_channel(AGAA_SOURCE_NORMAL_Y));
}

// Emission as stored: in shares of the layout's range, or of range times diffuse.
vec3 agaa_storedEmissive() {
    if (AGAA_EMISSIVE_CHANNELS == 3u)
        return agaa_channel3(AGAA_SOURCE_EMISSIVE_R, AGAA_SOURCE_EMISSIVE_G, AGAA_SOURCE_EMISSIVE_B);
    return AGAA_EMISSIVE_CHANNELS == 1u ? vec3(agaa_channel(AGAA_SOURCE_EMISSIVE_R)) : vec3(0.0);
}

vec3 agaa_fetchedNormal() { return agaa_decodeOct(agaa_normalCode(), AGAA_SOURCE_NORMAL_X >> 16); }

vec3 agaa_fetchedDiffuse() {
    return agaa_channel3(AGAA_SOURCE_DIFFUSE_R, AGAA_SOURCE_DIFFUSE_G, AGAA_SOURCE_DIFFUSE_B);
}

vec3 agaa_fetchedSpecular() {
    return agaa_channel3(AGAA_SOURCE_SPECULAR_R, AGAA_SOURCE_SPECULAR_G, AGAA_SOURCE_SPECULAR_B);
}

float agaa_fetchedAlpha2() {
    return AGAA_SOURCE_ROUGHNESS >> 16 != 0u ? agaa_channel(AGAA_SOURCE_ROUGHNESS) : 1.0;
}
#endif

agaa_Surface agaa_sampleSurface() {
    agaa_Surface s;
    s.diffuse = agaa_fetchedDiffuse();
    s.normal = agaa_fetchedNormal();
    s.meanLength = 1.0;
    s.alpha2Along = 0.0;
    s.axis = vec3(0.0);
    s.specular = vec3(0.0);
    s.alpha2 = 1.0;
    if (AGAA_HAS_SPECULAR != 0u) {
        s.specular = agaa_fetchedSpecular();
        s.alpha2 = agaa_fetchedAlpha2();
    }
    s.emissive = agaa_frame.ambient.w * agaa_storedEmissive();
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        s.emissive *= s.diffuse;
    return s;
}
#endif
