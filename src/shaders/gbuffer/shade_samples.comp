// Shading of a multisampled G-buffer: of every covered sample, or, where pixels are classified, once of those
// that show one surface (Lauritzen 2010).
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
#include "gbuffer/gbuffer.glsl"
#include "gbuffer/sample_visibility.glsl"
#define AGAA_MAX_EVENTS AGAA_SAMPLES
#include "common/tile.glsl"

#if AGAA_CLASSIFIED
#include "gbuffer/classify.glsl"
#endif

const uint agaa_wholePixel = 32u; // kind of event: one for all of the pixel's samples

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
    agaa_fetchSample(pixel, i);
    agaa_Surface s = agaa_sampleSurface();
    return (agaa_showsEvents() ? agaa_shownOfEvent(0u, 0.0, s.diffuse) : agaa_lightSurface(s, agaa_samplePosition(pixel, i))) *
           float(bitCount(mask));
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
