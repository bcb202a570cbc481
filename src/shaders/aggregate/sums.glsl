// Sums of an aggregate's attributes, quantised as fragments that accumulate them are.
#ifndef AGAA_SUMS_GLSL
#define AGAA_SUMS_GLSL
#include "aggregate/packing.glsl"

layout(std430, AGAA_BINDING_AGGREGATES) buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

uint agaa_sums[AGAA_MAX_WORDS];

void agaa_clearSums() {
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_sums[w] = 0u;
}

// Of `count` samples.
void agaa_addToSums(agaa_Stored v, uint count) {
    agaa_packSurface(v);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_sums[w] = agaa_isUnfilteredWord(w) ? max(agaa_sums[w], agaa_packed[w])
                                                : agaa_sums[w] + agaa_packed[w] * count;
}

// mask: its samples; base: the aggregate's first word.
void agaa_storeSums(uint mask, uint base) {
    agaa_sums[AGAA_FIELD_COVERAGE & 0xFFu] |= mask << (AGAA_FIELD_COVERAGE >> 8u & 0xFFu);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_aggregates.words[base + w] = agaa_sums[w];
}
#endif
