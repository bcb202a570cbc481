// A pixel's samples as the clustering takes them, from the prepass or from a G-buffer.
#ifndef AGAA_SAMPLES_GLSL
#define AGAA_SAMPLES_GLSL
#include "math/encoding.glsl"
#include "math/clustering.glsl"
#include "passes/sample_depth.glsl"
#include "passes/stored.glsl"

#ifndef AGAA_FROM_GBUFFER
#define AGAA_FROM_GBUFFER 0
#endif
#ifdef AGAA_HOST_FETCH
#include "passes/fetch.glsl"
#include "passes/sample_ids.glsl"
#endif
#if AGAA_FROM_GBUFFER || defined(AGAA_SOME_UNFETCHED)
#include "passes/gbuffer.glsl"
#endif
#if !defined(AGAA_HOST_FETCH) && !AGAA_FROM_GBUFFER
layout(AGAA_AT_SURFACE0) uniform AGAA_TARGET_TEXTURE agaa_normals;
#endif

#ifndef AGAA_HOST_FETCH
// The normal of a sample in the frame of agaa_normalFrame(), and a number that is equal for
// equal normals. False where there is no geometry.
bool agaa_loadNormal(uvec2 pixel, uint i, out vec3 normal, out uint code) {
#if AGAA_FROM_GBUFFER
    if (!agaa_fetchSample(pixel, i))
        return false;
    normal = agaa_fetchedNormal();
    uvec2 c = uvec2(agaa_normalCode() * 65535.0 + 0.5);
    code = (c.x << 16 | c.y) * 2654435761u >> 16;
#else
    uvec2 c = uvec2(AGAA_FETCH(agaa_normals, pixel, i).xy * 255.0 + 0.5);
    if (c.x + c.y == 0u)
        return false;
    normal = agaa_decodeHemiOct8(c);
    code = c.x << 8 | c.y;
#endif
    return true;
}
#endif

// Whether samples of one plane may be in several aggregates (AGAA_CONFIG_SPLIT_SURFACES): the planner then asks for a
// cosine that no two normals have.
bool agaa_splitsSurfaces() { return AGAA_AGGREGATES > 1u && agaa_frame.surface.x > 1.0; }

struct agaa_PixelSamples {
    uint covered;
    float nearest;  // distance
    float nearestZ; // along the view
};

// Normals, for the clustering alone, as long as their gloss makes differences count: w = weight / alpha, [1;20].
void agaa_weighNormal(uint i, vec3 shadingNormal, float alpha2) {
    float w = clamp(uintBitsToFloat(AGAA_GLOSS_WEIGHT) * inversesqrt(max(alpha2, agaa_minAlpha2())), 1.0, 20.0);
    agaa_sampleNormal[i] = sqrt(w) * shadingNormal;
}

agaa_PixelSamples agaa_noSamples() { return agaa_PixelSamples(0u, 3.0e38, 3.0e38); }

// While samples are added, the distance is its square.
agaa_PixelSamples agaa_withDistance(agaa_PixelSamples samples) {
    samples.nearest = sqrt(samples.nearest);
    return samples;
}

// One more sample that shows geometry. normal: in the frame of the positions; code: equal for equal normals.
void agaa_addSample(inout agaa_PixelSamples samples, uvec2 pixel, uint i, vec3 normal, uint code) {
    samples.covered |= 1u << i;
    float depth = agaa_depthOf(pixel, i);
    vec3 position = agaa_sampleViewPosition(pixel, i, depth);
    uvec2 place = uvec2(agaa_sampleLocation(i) * 128.0);
    float quantum = agaa_frame.projection1.w;
    quantum = quantum < 0.0 ? -quantum * depth : quantum; // float formats: relative
    float depthStep = agaa_depthQuantum(position.z, depth, agaa_frame.projection1.x, agaa_frame.projection1.y,
                                        agaa_isOrthographic(), quantum);
    agaa_setSample(i, position, normal, depthStep, floatBitsToUint(depth), code << 16 | place.x << 8 | place.y);
    samples.nearest = min(samples.nearest, dot(position, position));
    samples.nearestZ = min(samples.nearestZ, abs(position.z));
}

#ifndef AGAA_HOST_FETCH
// Normals come in a frame of their own; planes want that of the positions.
mat3 agaa_normalFrame(uvec2 pixel) {
#if AGAA_FROM_GBUFFER
    return mat3(agaa_frame.view);
#else
    vec2 centre = (vec2(pixel) + 0.5) / vec2(agaa_frame.size.xy) * 2.0 - 1.0;
    vec3 ray = agaa_viewPosition(centre, -1.0, agaa_frame.projection0.x, agaa_frame.projection0.y,
                                 agaa_frame.projection0.z, agaa_frame.projection0.w,
                                 agaa_isOrthographic());
    vec3 v = agaa_isOrthographic() != 0u ? vec3(0.0, 0.0, 1.0) : normalize(-ray);
    vec3 t, b;
    agaa_viewBasis(v, t, b);
    return mat3(t, b, v);
#endif
}

void agaa_addSamples(inout agaa_PixelSamples samples, uvec2 pixel) {
    mat3 frame = agaa_normalFrame(pixel);
    uint i = 0u;
    do {
        vec3 normal;
        uint code;
        if (agaa_loadNormal(pixel, i, normal, code))
            agaa_addSample(samples, pixel, i, frame * normal, code);
    } while (++i < agaa_sampleCount());
}

#if AGAA_FROM_GBUFFER
void agaa_weighFetchedNormals(uvec2 pixel, uint covered) {
    uint i = 0u;
    do
        if ((covered >> i & 1u) != 0u && agaa_fetchSample(pixel, i))
            agaa_weighNormal(i, agaa_sampleNormal[i], agaa_fetchedAlpha2());
    while (++i < agaa_sampleCount());
}
#endif

agaa_PixelSamples agaa_loadSamples(uvec2 pixel) {
    agaa_PixelSamples samples = agaa_noSamples();
    agaa_addSamples(samples, pixel);
    return agaa_withDistance(samples);
}
#endif

float agaa_pixelCharacteristicLength(agaa_PixelSamples samples) {
    float distance = agaa_scaleDistance(samples.nearest, agaa_frame.projection0.x, agaa_isOrthographic());
    return agaa_characteristicLength(agaa_frame.cluster.x, agaa_frame.cluster.y, distance);
}

// How far from its plane a surface may be, beside the steps of depth.
float agaa_surfaceWidth(agaa_PixelSamples samples) {
    return agaa_frame.surface.y * agaa_pixelWidth(samples.nearestZ);
}
#endif
