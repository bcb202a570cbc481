// Aggregate definition: assigns each sample of a pixel to an aggregate (AGAA section 3.3).
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
#include "aggregate/grouping.glsl"
#include "math/metadata.glsl"

layout(AGAA_BINDING_METADATA_OUT) writeonly uniform uimage2D agaa_metadata;

bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered) { return true; }

void agaa_weighNormals(uvec2 pixel, uint covered) {
#if AGAA_FROM_GBUFFER
    agaa_weighFetchedNormals(pixel, covered);
#endif
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, agaa_frame.size)))
        return;
    agaa_PixelSamples samples = agaa_loadSamples(pixel);
    uvec2 planes = uvec2(0u);
    if (agaa_groupSamples(pixel, samples, agaa_sampleCount()) > 1u) {
        for (uint i = 0u; i < agaa_sampleCount(); ++i)
            if ((samples.covered >> i & 1u) != 0u)
                agaa_putAggregateId(planes, i, agaa_sampleAggregate[i]);
    }
    planes = agaa_storedPlanes(planes, AGAA_SAMPLES, AGAA_AGGREGATES);
    imageStore(agaa_metadata, ivec2(pixel), uvec4(planes, 0u, 0u));
}
