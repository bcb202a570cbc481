// Sums of an aggregate's attributes, quantised like those that fragments accumulate. Needs AGAA_BINDING_AGGREGATES.
#ifndef AGAA_SUMS_GLSL
#define AGAA_SUMS_GLSL
#ifndef AGAA_BINDING_AGGREGATES
#error "sums.glsl needs AGAA_BINDING_AGGREGATES."
#endif
#include "aggregate/packing.glsl"
#include "math/normal_moments.glsl"
#include "tables/layouts.inc"

layout(std430, AGAA_BINDING_AGGREGATES) buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

uint agaa_sums[AGAA_MAX_WORDS];
uint agaa_momentSums[AGAA_MOMENT_WORDS]; // stored if AGAA_SPREAD_WORDS is not 0

void agaa_clearSums() {
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_sums[w] = 0u;
    for (uint m = 0u; m < AGAA_MOMENT_WORDS; ++m)
        agaa_momentSums[m] = 0u;
}

// Adds the class of `count` samples to a word with the vote of agaa_voteForClass(): the class, and above it the margin.
uint agaa_votedWord(uint word, uint class_, uint count) {
    uint margin = word >> 8u;
    if ((word & 0xFFu) == class_)
        return word + (count << 8u);
    return count > margin ? class_ | (count - margin) << 8u : word - (count << 8u);
}

// Adds the attributes of `count` samples.
void agaa_addToSums(agaa_Stored v, uint count) {
    agaa_packSurface(v);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_sums[w] = w + 1u == AGAA_CLASS_WORD    ? agaa_votedWord(agaa_sums[w], agaa_packed[w], count)
                       : agaa_isUnfilteredWord(w) ? max(agaa_sums[w], agaa_packed[w])
                                                  : agaa_sums[w] + agaa_packed[w] * count;
    for (uint m = 0u; m < AGAA_SPREAD_WORDS; ++m)
        agaa_momentSums[m] += agaa_momentCode(m, v.normal) * count;
}

// mask   Samples of the aggregate.
// base   Index of its first word.
void agaa_storeSums(uint mask, uint base) {
    agaa_sums[AGAA_FIELD_COVERAGE & 0xFFu] |= mask << (AGAA_FIELD_COVERAGE >> 8u & 0xFFu);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_aggregates.words[base + w] = agaa_sums[w];
    for (uint m = 0u; m < AGAA_SPREAD_WORDS; ++m)
        agaa_aggregates.words[base + AGAA_WORDS + m] = agaa_momentSums[m];
}
#endif
