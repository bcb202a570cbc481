// Selects the surfaces of a pixel that are kept, and the sample by which each is shaded (SBAA, Salvi and Vidimce 2012).
// It writes 0 to the attributes of surfaces, which generation fills.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_COUNTING 0
#define AGAA_MAX_SAMPLES AGAA_SAMPLES
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "aggregate/samples.glsl"
#include "math/sbaa_records.glsl"
#include "math/sbaa_surfaces.glsl"

layout(std430, AGAA_BINDING_AGGREGATES) writeonly buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

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
    uint base = (pixel.y * agaa_frame.size.x + pixel.x) * (AGAA_AGGREGATES * AGAA_STRIDE);
    for (uint s = 0u; s < AGAA_AGGREGATES; ++s, base += AGAA_STRIDE) {
        for (uint w = 0u; w < AGAA_WORDS; ++w)
            agaa_aggregates.words[base + w] = 0u;
        uvec2 record = s < count
                           ? agaa_storedSurface(agaa_surfaceSamples[s], agaa_surfaceShaded[s], AGAA_SAMPLES)
                           : uvec2(0u);
        agaa_aggregates.words[base + AGAA_WORDS] = record.x;
        if (AGAA_SAMPLES > 16u)
            agaa_aggregates.words[base + AGAA_WORDS + 1u] = record.y;
    }
}
