// Reads aggregates from attachments, in which additive blending has summed them (math/blended_sums.glsl), in place of
// aggregate/stored_aggregate.glsl. Needs AGAA_BLENDED_TARGETS, the number of attachments, and AGAA_BLENDED_SAMPLES, the
// number of their samples, of which each is an aggregate.
#ifndef AGAA_BLENDED_AGGREGATE_GLSL
#define AGAA_BLENDED_AGGREGATE_GLSL
#if !defined(AGAA_BLENDED_TARGETS) || !defined(AGAA_BLENDED_SAMPLES)
#error "blended_aggregate.glsl needs AGAA_BLENDED_TARGETS and AGAA_BLENDED_SAMPLES."
#endif
#include "math/blended_sums.glsl"

#if AGAA_BLENDED_SAMPLES > 1
#define AGAA_BLENDED_TEXTURE sampler2DMS
#else
#define AGAA_BLENDED_TEXTURE sampler2D
#endif
#define AGAA_FETCH_BLENDED(image) texelFetch(image, agaa_blendedPixel, agaa_blendedSample)
layout(AGAA_BINDING_BLENDED0) uniform AGAA_BLENDED_TEXTURE agaa_blended0;
#if AGAA_BLENDED_TARGETS > 1
layout(AGAA_BINDING_BLENDED1) uniform AGAA_BLENDED_TEXTURE agaa_blended1;
#endif
#if AGAA_BLENDED_TARGETS > 2
layout(AGAA_BINDING_BLENDED2) uniform AGAA_BLENDED_TEXTURE agaa_blended2;
#endif
#if AGAA_BLENDED_TARGETS > 3
layout(AGAA_BINDING_BLENDED3) uniform AGAA_BLENDED_TEXTURE agaa_blended3;
#endif
#if AGAA_BLENDED_TARGETS > 4
layout(AGAA_BINDING_BLENDED4) uniform AGAA_BLENDED_TEXTURE agaa_blended4;
#endif
#if AGAA_BLENDED_TARGETS > 5
layout(AGAA_BINDING_BLENDED5) uniform AGAA_BLENDED_TEXTURE agaa_blended5;
#endif
#if AGAA_BLENDED_TARGETS > 6
layout(AGAA_BINDING_BLENDED6) uniform AGAA_BLENDED_TEXTURE agaa_blended6;
#endif
#if AGAA_BLENDED_TARGETS > 7
layout(AGAA_BINDING_BLENDED7) uniform AGAA_BLENDED_TEXTURE agaa_blended7;
#endif

ivec2 agaa_blendedPixel = ivec2(0); // of the current aggregate
int agaa_blendedSample = 0;
uint agaa_aggregateSamples = 0u; // number of its samples

void agaa_selectAggregate(uvec2 pixel, uint a) {
    agaa_blendedPixel = ivec2(pixel);
    agaa_blendedSample = int(a);
}

vec4 agaa_blendedTexel(uint attachment) {
    vec4 texel = vec4(0.0);
    if (attachment == 0u)
        texel = AGAA_FETCH_BLENDED(agaa_blended0);
#if AGAA_BLENDED_TARGETS > 1
    if (attachment == 1u)
        texel = AGAA_FETCH_BLENDED(agaa_blended1);
#endif
#if AGAA_BLENDED_TARGETS > 2
    if (attachment == 2u)
        texel = AGAA_FETCH_BLENDED(agaa_blended2);
#endif
#if AGAA_BLENDED_TARGETS > 3
    if (attachment == 3u)
        texel = AGAA_FETCH_BLENDED(agaa_blended3);
#endif
#if AGAA_BLENDED_TARGETS > 4
    if (attachment == 4u)
        texel = AGAA_FETCH_BLENDED(agaa_blended4);
#endif
#if AGAA_BLENDED_TARGETS > 5
    if (attachment == 5u)
        texel = AGAA_FETCH_BLENDED(agaa_blended5);
#endif
#if AGAA_BLENDED_TARGETS > 6
    if (attachment == 6u)
        texel = AGAA_FETCH_BLENDED(agaa_blended6);
#endif
#if AGAA_BLENDED_TARGETS > 7
    if (attachment == 7u)
        texel = AGAA_FETCH_BLENDED(agaa_blended7);
#endif
    return texel;
}

// Returns the code of a channel. A field has the attachment in place of the word and the component in place of the
// shift.
uint agaa_blendedField(uint field) {
    return agaa_blendedCode(agaa_blendedTexel(field & 0xFFu)[field >> 8u & 0x3u], agaa_fieldBits(field));
}

// Samples beyond the first eight have a channel for each eight, in the last attachment.
uint agaa_coverage() {
    uint mask = agaa_blendedField(AGAA_FIELD_COVERAGE);
    if (AGAA_SAMPLES > 8u) {
        vec4 beyond = agaa_blendedTexel(uint(AGAA_BLENDED_TARGETS) - 1u);
        for (uint part = 1u; part < AGAA_SAMPLES / 8u; ++part)
            mask |= agaa_blendedCode(beyond[part - 1u], 8u) << (8u * part);
    }
    return mask;
}

float agaa_meanOf(uint field) {
    const uint bits = agaa_fieldBits(field);
    float mean = 0.0;
    if (bits != 0u) {
        const uint sum = agaa_blendedField(field);
        mean = agaa_isSignedField(field) ? agaa_signedMeanOfBlended(sum, agaa_aggregateSamples, AGAA_SAMPLES, bits)
                                         : agaa_meanOfBlended(sum, agaa_aggregateSamples, AGAA_SAMPLES, bits);
    }
    return mean;
}

agaa_Stored agaa_storedMeans() {
    agaa_Stored v;
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) v.member = agaa_meanOf(field);
#include "tables/channels.inc"
    return v;
}

// Attachments keep no second moments.
agaa_SecondMoments agaa_storedMoments() { return agaa_SecondMoments(vec3(0.0), vec3(0.0)); }

// Returns the bound by which rounding may shorten the normal: half a code for each of up to n fragments.
float agaa_summedLengthBound() { return agaa_storedLengthBound(AGAA_SAMPLES, agaa_fieldBits(AGAA_FIELD_NORMAL_X)); }
#endif
