// Aggregate generation from a multisampled G-buffer: adds each sample's attributes to its aggregate. The sums equal
// those of the tiers that accumulate fragments, and need no atomics.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "gbuffer/gbuffer.glsl"
#include "aggregate/sums.glsl"
#include "math/metadata.glsl"
#include "math/sbaa_records.glsl"

#if AGAA_MULTIPLE_AGGREGATES
layout(AGAA_BINDING_METADATA) uniform usampler2D agaa_metadata;
#endif

// Returns the samples of the pixel whose attributes are summed for an aggregate.
uint agaa_summedSamples(uvec2 planes, uint a, uint base) {
#if AGAA_REPRESENTED
    uvec2 record = uvec2(agaa_aggregates.words[base + AGAA_WORDS], 0u);
    if (AGAA_SAMPLES > 16u)
        record.y = agaa_aggregates.words[base + AGAA_WORDS + 1u];
    return agaa_recordSamples(record, AGAA_SAMPLES) == 0u ? 0u
                                                          : 1u << agaa_recordShaded(record, AGAA_SAMPLES);
#else
    return agaa_samplesOfAggregate(planes, a);
#endif
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, agaa_frame.size)))
        return;
    uvec2 planes = uvec2(0u);
#if AGAA_MULTIPLE_AGGREGATES && !AGAA_REPRESENTED
    planes = agaa_loadedPlanes(texelFetch(agaa_metadata, ivec2(pixel), 0).xy, AGAA_SAMPLES,
                               AGAA_AGGREGATES);
#endif
    uint base = (pixel.y * agaa_frame.size.x + pixel.x) * (AGAA_AGGREGATES * AGAA_STRIDE);
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a, base += AGAA_STRIDE) {
        agaa_clearSums();
        uint summed = agaa_summedSamples(planes, a, base);
        uint mask = 0u;
        for (uint i = 0u; i < AGAA_SAMPLES; ++i)
            if ((summed >> i & 1u) != 0u && agaa_fetchSample(pixel, i)) {
                mask |= AGAA_REPRESENTED != 0 ? 1u : 1u << i;
                agaa_addToSums(agaa_storedSample(), 1u);
            }
        agaa_storeSums(mask, base);
    }
}
