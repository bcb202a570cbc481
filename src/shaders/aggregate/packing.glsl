// Packs a fragment's attributes as the words of an aggregate: quantised values, which aggregates sum.
#ifndef AGAA_PACKING_GLSL
#define AGAA_PACKING_GLSL
#include "aggregate/aggregate_input.glsl"

#ifndef AGAA_MAX_WORDS
// The maximum is a word for each channel and one for the coverage.
const uint agaa_maxWords = 1u
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) + 1u
#include "tables/channels.inc"
    ;
#define AGAA_MAX_WORDS agaa_maxWords
#endif
uint agaa_packed[AGAA_MAX_WORDS]; // words of one fragment, by agaa_packSurface()

void agaa_pack(uint field, float value) {
    uint bits = agaa_fieldBits(field);
    if (bits != 0u)
        agaa_packed[field & 0xFFu] |=
            (agaa_isSignedField(field) ? agaa_signedCode(value, bits) : agaa_quantise(value, bits))
            << (field >> 8u & 0xFFu);
}

// Packs the words that a fragment adds to an aggregate for each of its samples.
void agaa_packSurface(agaa_Stored v) {
    v = agaa_aggregateInput(v);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_packed[w] = 0u;
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) agaa_pack(field, v.member);
#include "tables/channels.inc"
}

bool agaa_isUnfilteredWord(uint w) { return (AGAA_UNFILTERED_WORDS >> w & 1u) != 0u; }

// Returns the value of an unfiltered word that competes with others: of a class, the number of its samples comes first.
uint agaa_unfilteredWord(uint w, uint count) {
    return w + 1u == AGAA_CLASS_WORD ? agaa_packed[w] | count << 8u : agaa_packed[w];
}
#endif
