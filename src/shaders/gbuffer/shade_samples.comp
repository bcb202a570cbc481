// Shades a multisampled G-buffer: each covered sample or, with AGAA_CLASSIFIED, once per pixel that shows one surface
// (Lauritzen 2010). One surface has samples whose normals, planes and materials differ by no more than the frame's
// thresholds.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "common/event_light.glsl"
#include "gbuffer/gbuffer.glsl"
#include "gbuffer/sample_visibility.glsl"
#define AGAA_MAX_EVENTS AGAA_SAMPLES
#include "common/tile.glsl"

#if AGAA_CLASSIFIED
float agaa_materialDifference(agaa_Surface a, agaa_Surface b) {
    float d = agaa_colorDifference(a.diffuse, b.diffuse);
    if (AGAA_HAS_SPECULAR != 0u)
        d = max(d, max(agaa_colorDifference(a.specular, b.specular), abs(a.alpha2 - b.alpha2)));
    if (AGAA_EMISSIVE_CHANNELS != 0u)
        d = max(d, agaa_colorDifference(agaa_displayed(a.emissive), agaa_displayed(b.emissive)));
    return d;
}

// Returns whether the pixel shows several surfaces. mask: one or more samples with geometry.
bool agaa_isComplex(uvec2 pixel, uint mask) {
    uint i = uint(findLSB(mask));
    agaa_fetchSample(pixel, i);
    agaa_Surface first = agaa_sampleSurface();
    first.normal = mat3(agaa_frame.view) * first.normal;
    vec3 at = agaa_sampleViewPosition(pixel, i, agaa_depthOf(pixel, i));
    float farthest = agaa_frame.surfaceDistance * agaa_pixelWidth(at.z); // distance from the plane of the first sample
    bool complex = false;
    for (uint rest = mask & (mask - 1u); rest != 0u && !complex; rest &= rest - 1u) {
        i = uint(findLSB(rest));
        agaa_fetchSample(pixel, i);
        agaa_Surface s = agaa_sampleSurface();
        s.normal = mat3(agaa_frame.view) * s.normal;
        vec3 p = agaa_sampleViewPosition(pixel, i, agaa_depthOf(pixel, i));
        complex = dot(first.normal, s.normal) < agaa_frame.surfaceCosine ||
                  abs(dot(first.normal, p - at)) > farthest ||
                  agaa_materialDifference(first, s) > agaa_frame.surfaceMaterial;
    }
    return complex;
}
#endif

const uint agaa_wholePixel = 32u; // kind of an event that represents all samples of the pixel

uint agaa_coveredSamples(uvec2 pixel) {
    uint covered = 0u;
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        if (agaa_isCovered(pixel, i))
            covered |= 1u << i;
    return covered;
}

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    uint mask = agaa_coveredSamples(pixel);
    uint covered = uint(bitCount(mask));
    agaa_PixelWork work = agaa_pixelWork(mask, 0u, covered);
#if AGAA_CLASSIFIED
    if (covered > 1u && !agaa_isComplex(pixel, mask))
        work = agaa_pixelWork(mask & (~mask + 1u), agaa_wholePixel, covered);
#endif
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_countEvents(agaa_eventsOf(work));
    agaa_count(AGAA_COUNT_PIXELS, covered != 0u ? 1u : 0u);
    return work;
}

vec3 agaa_shadeEvent(uint lane, uint which) {
    uvec2 pixel = agaa_pixelOf(lane);
    uint i = which & 31u;
    uint mask = 1u << i;
#if AGAA_CLASSIFIED
    if ((which & agaa_wholePixel) != 0u)
        mask = agaa_coveredSamples(pixel);
#endif
    agaa_findVisibility(pixel, mask);
    agaa_findSpread(pixel, i, mask);
    agaa_fetchSample(pixel, i);
    agaa_setEventCustom(agaa_fetchedCustom());
    return agaa_eventLight(0u, 0.0, agaa_sampleSurface(), agaa_samplePosition(pixel, i)) * float(bitCount(mask));
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
