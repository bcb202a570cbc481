// Generation from a multisampled G-buffer: each sample's attributes are added to its aggregate. Sums are
// those of the tiers that accumulate fragments, without atomics.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/gbuffer.glsl"
#include "math/metadata.glsl"
#include "math/ndf.glsl"
#include "math/records.glsl"

#if AGAA_SEVERAL
layout(AGAA_AT_METADATA) uniform usampler2D agaa_metadata;
#endif
layout(std430, AGAA_AT_AGGREGATES) buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

const uint agaa_maxWords = 14u; // 13 channels and the coverage, a word each at most
uint agaa_sums[agaa_maxWords];

void agaa_add(uint field, float value) {
    if (field >> 16 != 0u)
        agaa_sums[field & 0xFFu] += agaa_quantise(value, field >> 16) << (field >> 8u & 0xFFu);
}

void agaa_add3(uint x, uint y, uint z, vec3 value) {
    agaa_add(x, value.x);
    agaa_add(y, value.y);
    agaa_add(z, value.z);
}

void agaa_addSample() {
    agaa_Surface s = agaa_sampleSurface();
    vec3 n = s.normal;
    if (AGAA_FOLDED_ROUGHNESS != 0u)
        n *= agaa_foldedLength(s.alpha2);
    vec3 specular = AGAA_YCBCR_SPECULAR != 0u ? agaa_rgbToYCbCr(s.specular) : s.specular;
    agaa_add3(AGAA_FIELD_DIFFUSE_R, AGAA_FIELD_DIFFUSE_G, AGAA_FIELD_DIFFUSE_B, s.diffuse);
    agaa_add3(AGAA_FIELD_SPECULAR_R, AGAA_FIELD_SPECULAR_G, AGAA_FIELD_SPECULAR_B, specular);
    agaa_add3(AGAA_FIELD_NORMAL_X, AGAA_FIELD_NORMAL_Y, AGAA_FIELD_NORMAL_Z, n * 0.5 + 0.5);
    agaa_add(AGAA_FIELD_ROUGHNESS, s.alpha2);
    agaa_add3(AGAA_FIELD_EMISSIVE_R, AGAA_FIELD_EMISSIVE_G, AGAA_FIELD_EMISSIVE_B,
              agaa_storedEmissive());
}

// Samples whose attributes are summed for an aggregate, of those in the pixel.
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
    if (any(greaterThanEqual(pixel, agaa_frame.size.xy)))
        return;
    uvec2 planes = uvec2(0u);
#if AGAA_SEVERAL && !AGAA_REPRESENTED
    planes = agaa_loadedPlanes(texelFetch(agaa_metadata, ivec2(pixel), 0).xy, AGAA_SAMPLES,
                               AGAA_AGGREGATES);
#endif
    uint base = (pixel.y * agaa_frame.size.x + pixel.x) * (AGAA_AGGREGATES * AGAA_STRIDE);
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a, base += AGAA_STRIDE) {
        for (uint w = 0u; w < agaa_maxWords; ++w)
            agaa_sums[w] = 0u;
        uint own = agaa_summedSamples(planes, a, base);
        uint mask = 0u;
        for (uint i = 0u; i < AGAA_SAMPLES; ++i)
            if ((own >> i & 1u) != 0u && agaa_fetchSample(pixel, i)) {
                mask |= AGAA_REPRESENTED != 0 ? 1u : 1u << i;
                agaa_addSample();
            }
        agaa_sums[AGAA_FIELD_COVERAGE & 0xFFu] |= mask << (AGAA_FIELD_COVERAGE >> 8u & 0xFFu);
        for (uint w = 0u; w < AGAA_WORDS; ++w)
            agaa_aggregates.words[base + w] = agaa_sums[w];
    }
}
