// Aggregate definition: which aggregate each sample of a pixel belongs to (AGAA section 3.3).
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_COUNTING 0
#define AGAA_MAX_SAMPLES 32
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/samples.glsl"
#include "math/metadata.glsl"
#include "math/surfaces.glsl"

layout(AGAA_AT_METADATA_OUT) writeonly uniform uimage2D agaa_metadata;

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, agaa_frame.size.xy)))
        return;
    agaa_PixelSamples samples = agaa_loadSamples(pixel);
    float k = agaa_pixelCharacteristicLength(samples);
    uvec2 planes = uvec2(0u);
    // Distance along a slanted surface would part its samples, though they are shaded nearly alike.
    bool parted = samples.covered != 0u &&
                  !agaa_areAllOneSurface(agaa_sampleCount(), samples.covered, agaa_frame.surface.x,
                                         agaa_surfaceWidth(samples));
#if AGAA_FROM_GBUFFER
    if (parted && AGAA_GLOSS_WEIGHT != 0u)
        agaa_weighNormals(pixel, samples.covered);
#endif
    if (parted && agaa_defineAggregates(agaa_sampleCount(), samples.covered, AGAA_AGGREGATES, k,
                                        agaa_frame.cluster.z, AGAA_SEEDS) > 1u) {
        for (uint i = 0u; i < agaa_sampleCount(); ++i)
            if ((samples.covered >> i & 1u) != 0u)
                agaa_putAggregateId(planes, i, agaa_sampleAggregate[i]);
    }
    planes = agaa_storedPlanes(planes, AGAA_SAMPLES, AGAA_AGGREGATES);
    imageStore(agaa_metadata, ivec2(pixel), uvec4(planes, 0u, 0u));
}
