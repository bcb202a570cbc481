// Aggregate definition: assigns each sample of a pixel to an aggregate (AGAA section 3.3). A lane has a pixel or, with
// AGAA_SAMPLE_LANES, a sample.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/subgroup_extensions.glsl"
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
#include "common/counters.glsl"
#include "aggregate/samples.glsl"
#include "math/sbaa_surfaces.glsl"
#if AGAA_SAMPLE_LANES
#include "aggregate/lane_samples.glsl"
#include "common/tile_pixels.glsl"
#else
#include "aggregate/grouping.glsl"
#endif
#include "math/metadata.glsl"

layout(AGAA_BINDING_METADATA_OUT) writeonly uniform uimage2D agaa_metadata;

void agaa_writeMetadata(uvec2 pixel, uvec2 planes) {
    imageStore(agaa_metadata, ivec2(pixel), uvec4(agaa_storedPlanes(planes, AGAA_SAMPLES, AGAA_AGGREGATES), 0u, 0u));
}

#if AGAA_SAMPLE_LANES
void agaa_define() {
    for (uint iteration = 0u; iteration < agaa_pixelLanes; ++iteration) {
        uvec2 pixel = agaa_pixelOf(agaa_lanePixel(iteration));
        agaa_LaneSample s = agaa_loadLaneSample(pixel);
        agaa_LaneGroup group = agaa_groupLanes(s, false);
        uvec2 planes = uvec2(agaa_samplesWhere((group.aggregate & 1u) != 0u),
                             agaa_samplesWhere((group.aggregate & 2u) != 0u));
        if (agaa_laneSample() == 0u && all(lessThan(pixel, agaa_frame.size))) {
            agaa_writeMetadata(pixel, planes);
            agaa_count(AGAA_COUNT_JOINED_CLASSES, uint(bitCount(group.joining)));
        }
    }
}
#else
bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered) { return true; }

void agaa_weighNormals(uvec2 pixel, uint covered) {
#if AGAA_FROM_GBUFFER
    agaa_weighFetchedNormals(pixel, covered);
#endif
}

void agaa_define() {
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
    agaa_writeMetadata(pixel, planes);
    agaa_count(AGAA_COUNT_JOINED_CLASSES, uint(bitCount(agaa_joiningSamples)));
}
#endif

void main() {
    agaa_countBegin();
    agaa_define();
    agaa_countEnd();
}
