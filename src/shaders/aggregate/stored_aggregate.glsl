// Reads aggregates from memory, in passes of the SDK and of hosts. Needs AGAA_IMAGE_WIDTH, AGAA_EMISSIVE_RANGE,
// AGAA_REPRESENTED, and AGAA_AGGREGATE_WORD(i), which reads word i of the buffer. Hosts may define the latter as a
// function, so it is not checked.
#ifndef AGAA_STORED_AGGREGATE_GLSL
#define AGAA_STORED_AGGREGATE_GLSL
#if !defined(AGAA_IMAGE_WIDTH) || !defined(AGAA_EMISSIVE_RANGE) || !defined(AGAA_REPRESENTED)
#error "stored_aggregate.glsl needs AGAA_IMAGE_WIDTH, AGAA_EMISSIVE_RANGE and AGAA_REPRESENTED."
#endif
#include "aggregate/stored_means.glsl"
#include "math/encoding.glsl"
#include "math/ndf.glsl"
#include "math/normal_moments.glsl"
#include "math/sbaa_records.glsl"
#include "common/stored.glsl"

uint agaa_base = 0u;             // index of the first word of the current aggregate
uint agaa_aggregateSamples = 0u; // number of its samples

uint agaa_field(uint field) {
    uint bits = agaa_fieldBits(field);
    uint word = AGAA_AGGREGATE_WORD(agaa_base + (field & 0xFFu));
    return bitfieldExtract(word, int(field >> 8u & 0xFFu), int(bits));
}

#if AGAA_REPRESENTED
uvec2 agaa_record() {
    return uvec2(AGAA_AGGREGATE_WORD(agaa_base + AGAA_WORDS),
                 AGAA_SAMPLES > 16u ? AGAA_AGGREGATE_WORD(agaa_base + AGAA_WORDS + 1u) : 0u);
}

// A surface without a kept fragment covers no sample.
uint agaa_coverage() {
    return agaa_field(AGAA_FIELD_COVERAGE) != 0u ? agaa_recordSamples(agaa_record(), AGAA_SAMPLES) : 0u;
}

uint agaa_sum(uint field) { return agaa_field(field); }
uint agaa_summed() { return 1u; }
#else
uint agaa_coverage() { return agaa_field(AGAA_FIELD_COVERAGE); }

// Sums have log2(n) bits more than one fragment's value.
uint agaa_sum(uint field) { return agaa_field(field + (uint(findMSB(AGAA_SAMPLES)) << 16)); }

uint agaa_summed() { return agaa_aggregateSamples; }
#endif

// Returns the second moments of the normals. Aggregates have them if AGAA_SPREAD_WORDS is not 0.
agaa_SecondMoments agaa_storedMoments() {
    const uint at = agaa_base + AGAA_WORDS;
    return agaa_momentsOfSums(AGAA_AGGREGATE_WORD(at), AGAA_AGGREGATE_WORD(at + 1u), AGAA_AGGREGATE_WORD(at + 2u),
                              AGAA_AGGREGATE_WORD(at + 3u), AGAA_AGGREGATE_WORD(at + 4u), agaa_aggregateSamples);
}

float agaa_meanOf(uint field) {
    const uint bits = agaa_fieldBits(field);
    float mean = 0.0;
    if (bits != 0u) {
        if (agaa_isUnfilteredField(field))
            mean = agaa_meanOfSum(agaa_field(field), 1u, bits);
        else if (agaa_isSignedField(field))
            mean = agaa_signedMeanOfSum(agaa_sum(field), agaa_summed(), bits);
        else
            mean = agaa_meanOfSum(agaa_sum(field), agaa_summed(), bits);
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

void agaa_selectAggregate(uvec2 pixel, uint a) {
    agaa_base = ((pixel.y * (AGAA_IMAGE_WIDTH) + pixel.x) * AGAA_AGGREGATES + a) * AGAA_STRIDE;
}
#endif
