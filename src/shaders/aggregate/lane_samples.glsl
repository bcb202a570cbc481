// Loads the samples of pixels for the clustering with one lane per sample, from the prepass or from a G-buffer. Needs
// aggregate/samples.glsl and what aggregate/lane_clustering.glsl needs.
#ifndef AGAA_LANE_SAMPLES_GLSL
#define AGAA_LANE_SAMPLES_GLSL
#ifndef AGAA_SAMPLES_GLSL
#error "lane_samples.glsl needs samples.glsl."
#endif
#include "aggregate/lane_clustering.glsl"

// Loads the sample of this lane.
agaa_LaneSample agaa_loadLaneSample(uvec2 pixel) {
    agaa_LaneSample s = agaa_noLaneSample();
    const uint i = agaa_laneSample();
    vec3 normal;
    uint code;
    bool isInside = all(lessThan(pixel, agaa_frame.size)) && i < AGAA_SAMPLES;
    if (isInside) {
        if (agaa_loadNormal(pixel, i, normal, code)) {
#if AGAA_FROM_GBUFFER
            float alpha2 = agaa_fetchedAlpha2(); // before the depth, which the host may fetch
#endif
            float depth = agaa_depthOf(pixel, i);
            s = agaa_laneSampleAt(agaa_sampleViewPosition(pixel, i, depth), depth, agaa_storedQuantum(depth),
                                  agaa_sampleLocation(i), agaa_normalFrame(pixel) * normal, code);
#if AGAA_FROM_GBUFFER
            s.alpha2 = alpha2;
#endif
        }
    }
    return s;
}
#endif
