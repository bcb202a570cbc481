// Loads a pixel's samples for the clustering, from the prepass or from a G-buffer. Needs AGAA_MAX_SAMPLES and
// common/target.glsl.
#ifndef AGAA_SAMPLES_GLSL
#define AGAA_SAMPLES_GLSL
#include "math/encoding.glsl"
#include "aggregate/pixel_samples.glsl"
#include "common/sample_depth.glsl"
#include "common/custom_filters.glsl"

#ifndef AGAA_FROM_GBUFFER
#define AGAA_FROM_GBUFFER 0
#endif
#ifdef AGAA_HOST_FETCH
#include "ids/fetch.glsl"
#include "ids/sample_ids.glsl"
#endif
#if AGAA_FROM_GBUFFER || defined(AGAA_SOME_UNFETCHED)
#include "gbuffer/gbuffer.glsl"
#endif
#if !defined(AGAA_HOST_FETCH) && !AGAA_FROM_GBUFFER
#include "aggregate/prepass_normals.glsl"
#endif

#ifndef AGAA_HOST_FETCH
// Loads the normal of a sample in the frame of agaa_normalFrame(), and the code of agaa_codeWithClass(). Returns false
// where there is no geometry.
bool agaa_loadNormal(uvec2 pixel, uint i, out vec3 normal, out uint code) {
#if AGAA_FROM_GBUFFER
    if (!agaa_fetchSample(pixel, i))
        return false;
    normal = agaa_fetchedNormal();
    uvec2 c = uvec2(agaa_normalCode() * 65535.0 + 0.5);
    code = agaa_codeWithClass((c.x << 16 | c.y) * 2654435761u >> 16, agaa_classOf(agaa_fetchedCustom()), 1u);
#else
    uvec2 c = agaa_prepassCode(pixel, i);
    if (c.x + c.y == 0u)
        return false;
    normal = agaa_decodeHemiOct8(c);
    code = agaa_codeWithClass(c.x << 8 | c.y, AGAA_CLASSES ? agaa_prepassClass(pixel, i) : 0u, 1u);
#endif
    return true;
}
#endif

// Adds a sample with geometry.
// normal   In the frame of the positions.
// code     Of agaa_codeWithClass().
void agaa_addSample(inout agaa_PixelSamples samples, uvec2 pixel, uint i, vec3 normal, uint code) {
    float depth = agaa_depthOf(pixel, i);
    agaa_addSampleAt(samples, i, agaa_sampleViewPosition(pixel, i, depth), depth, agaa_storedQuantum(depth),
                     agaa_sampleLocation(i), normal, code);
}

#ifndef AGAA_HOST_FETCH
// Returns the rotation from the frame of stored normals to that of the positions, in which planes are compared.
mat3 agaa_normalFrame(uvec2 pixel) {
#if AGAA_FROM_GBUFFER
    return mat3(agaa_frame.view);
#else
    return agaa_prepassFrame(pixel);
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
#endif
