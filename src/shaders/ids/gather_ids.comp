// Aggregates the fetched materials of a pixel and writes the aggregates in the format of the tiers that accumulate
// fragments.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/subgroup_extensions.glsl"
#if AGAA_SAMPLE_LANES
#define AGAA_MAX_SAMPLES 1
#define AGAA_SAMPLE_WORDS AGAA_SAMPLES
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
#include "math/light.glsl"
#include "common/tile_pixels.glsl"
#include "ids/primitives.glsl"
#include "aggregate/sums.glsl"
#include "ids/stored_material.glsl"

void agaa_storeAggregate(uvec2 pixel, uint a, uint mask) {
    agaa_clearSums();
    uvec2 entries = agaa_entriesOf(gl_LocalInvocationIndex);
    for (uint at = entries.x; at < entries.y && mask != 0u; ++at) {
        agaa_Stored v = agaa_storedMaterial(agaa_listMaterial[at]);
        uint samples = agaa_listSamples[at] & mask;
        bool isCurved = agaa_isCurvedMaterial(agaa_listMaterial[at]);
        if (samples != 0u && !isCurved)
            agaa_addToSums(v, uint(bitCount(samples)));
        for (uint rest = isCurved ? samples : 0u; rest != 0u; rest &= rest - 1u) {
            v.normal = agaa_listedNormal(at, uint(findLSB(rest)));
            agaa_addToSums(v, 1u);
        }
    }
    agaa_storeSums(mask, ((pixel.y * agaa_frame.size.x + pixel.x) * AGAA_AGGREGATES + a) * AGAA_STRIDE);
}

// The pass that shades finds missing samples.
void agaa_shadeDeferredPixel(bool hasPixel, uvec2 pixel, uint covered, uint uncovered) {
    if (hasPixel)
        for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
            agaa_storeAggregate(pixel, a, agaa_masks[gl_LocalInvocationIndex * AGAA_AGGREGATES + a]);
}

void main() {
    agaa_countBegin();
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool inside = all(lessThan(pixel, agaa_frame.size));
    uint covered = inside ? agaa_loadIds(pixel) : 0u;
    if (inside && covered == 0u)
        for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
            agaa_storeAggregate(pixel, a, 0u);
    agaa_processPixels(pixel, covered);
    agaa_countEnd();
}
