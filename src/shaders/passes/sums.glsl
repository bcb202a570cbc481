// Sums of an aggregate's attributes, quantised as fragments that accumulate them are.
#ifndef AGAA_SUMS_GLSL
#define AGAA_SUMS_GLSL
#include "math/encoding.glsl"
#include "math/light.glsl"
#include "math/ndf.glsl"

layout(std430, AGAA_AT_AGGREGATES) buffer agaa_AggregateBlock {
    uint words[];
} agaa_aggregates;

const uint agaa_maxWords = 14u; // 13 channels and the coverage, a word each at most
uint agaa_sums[agaa_maxWords];

void agaa_clearSums() {
    for (uint w = 0u; w < agaa_maxWords; ++w)
        agaa_sums[w] = 0u;
}

void agaa_addCode(uint field, uint code, uint count) {
    if (field >> 16 != 0u)
        agaa_sums[field & 0xFFu] += code * count << (field >> 8u & 0xFFu);
}

void agaa_addToSum(uint field, float value, uint count) { agaa_addCode(field, agaa_quantise(value, field >> 16), count); }

void agaa_addSigned(uint field, float value, uint count) { agaa_addCode(field, agaa_signedCode(value, field >> 16), count); }

void agaa_addToSums3(uint x, uint y, uint z, vec3 value, uint count) {
    agaa_addToSum(x, value.x, count);
    agaa_addToSum(y, value.y, count);
    agaa_addToSum(z, value.z, count);
}

// Of `count` samples. storedEmissive: in shares of the layout's range, or of range times diffuse.
void agaa_addToSums(agaa_Surface s, vec3 storedEmissive, uint count) {
    vec3 n = s.normal;
    if (AGAA_FOLDED_ROUGHNESS != 0u)
        n *= agaa_foldedLength(s.alpha2);
    vec3 specular = AGAA_YCBCR_SPECULAR != 0u ? agaa_rgbToYCbCr(s.specular) : s.specular;
    agaa_addToSums3(AGAA_FIELD_DIFFUSE_R, AGAA_FIELD_DIFFUSE_G, AGAA_FIELD_DIFFUSE_B, s.diffuse, count);
    agaa_addToSums3(AGAA_FIELD_SPECULAR_R, AGAA_FIELD_SPECULAR_G, AGAA_FIELD_SPECULAR_B, specular, count);
    agaa_addSigned(AGAA_FIELD_NORMAL_X, n.x, count);
    agaa_addSigned(AGAA_FIELD_NORMAL_Y, n.y, count);
    agaa_addSigned(AGAA_FIELD_NORMAL_Z, n.z, count);
    agaa_addToSum(AGAA_FIELD_ROUGHNESS, s.alpha2, count);
    agaa_addToSums3(AGAA_FIELD_EMISSIVE_R, AGAA_FIELD_EMISSIVE_G, AGAA_FIELD_EMISSIVE_B, storedEmissive, count);
}

// mask: its samples; base: the aggregate's first word.
void agaa_storeSums(uint mask, uint base) {
    agaa_sums[AGAA_FIELD_COVERAGE & 0xFFu] |= mask << (AGAA_FIELD_COVERAGE >> 8u & 0xFFu);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_aggregates.words[base + w] = agaa_sums[w];
}
#endif
