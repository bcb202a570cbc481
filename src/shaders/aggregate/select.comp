// Selects the surfaces of a pixel that are kept, and the sample by which each is shaded (SBAA, Salvi and Vidimce 2012).
// It writes 0 to the attributes of surfaces, which generation fills. A lane has a pixel or, with AGAA_SAMPLE_LANES, a
// sample.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/subgroup_extensions.glsl"
#define AGAA_COUNTING 0
#if AGAA_SAMPLE_LANES
#define AGAA_MAX_SAMPLES 1
layout(local_size_x = 64) in;
#else
#define AGAA_MAX_SAMPLES AGAA_SAMPLES
layout(local_size_x = 8, local_size_y = 8) in;
#endif
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "aggregate/samples.glsl"
#include "math/sbaa_records.glsl"
#include "math/sbaa_surfaces.glsl"
#if AGAA_SAMPLE_LANES
#include "aggregate/lane_samples.glsl"
#include "aggregate/lane_surfaces.glsl"
#include "common/tile_pixels.glsl"
#endif

layout(std430, AGAA_BINDING_AGGREGATES) writeonly buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

// Writes surface s of a pixel, without attributes.
void agaa_writeSurface(uvec2 pixel, uint s, uvec2 record) {
    uint base = ((pixel.y * agaa_frame.size.x + pixel.x) * AGAA_AGGREGATES + s) * AGAA_STRIDE;
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_aggregates.words[base + w] = 0u;
    agaa_aggregates.words[base + AGAA_WORDS] = record.x;
    if (AGAA_SAMPLES > 16u)
        agaa_aggregates.words[base + AGAA_WORDS + 1u] = record.y;
}

#if AGAA_SAMPLE_LANES
void main() {
    for (uint iteration = 0u; iteration < agaa_pixelLanes; ++iteration) {
        uvec2 pixel = agaa_pixelOf(agaa_lanePixel(iteration));
        agaa_LaneSurface surface = agaa_selectSurfaceLane(agaa_loadLaneSample(pixel));
        if (agaa_laneSample() < AGAA_AGGREGATES && all(lessThan(pixel, agaa_frame.size)))
            agaa_writeSurface(pixel, agaa_laneSample(),
                              agaa_storedSurface(surface.samples, surface.shaded, AGAA_SAMPLES));
    }
}
#else
void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, agaa_frame.size)))
        return;
    agaa_PixelSamples samples = agaa_loadSamples(pixel);
    uint count = 0u;
    if (samples.covered != 0u) {
        count = agaa_selectSurfaces(agaa_sampleCount(), samples.covered, AGAA_AGGREGATES,
                                    agaa_frame.surfaceCosine, agaa_surfaceWidth(samples),
                                    agaa_lengthsFor(agaa_pixelCharacteristicLength(samples),
                                                    agaa_frame.aggregateThreshold));
    }
    for (uint s = 0u; s < AGAA_AGGREGATES; ++s)
        agaa_writeSurface(pixel, s,
                          s < count ? agaa_storedSurface(agaa_surfaceSamples[s], agaa_surfaceShaded[s], AGAA_SAMPLES)
                                    : uvec2(0u));
}
#endif
