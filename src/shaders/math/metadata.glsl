// Aggregate ids of the samples of one pixel, packed.
// Source: AGAA (Crassin et al., TVCG 2016) section 3.3, figure 5 and Algorithm 2; hard cases 29
// (the printed mask c-1 loses an id for c=3) and 30 (64 bits of metadata, shifts of 32 are
// undefined).
//
// An id never straddles two words: with 1 or 2 bits that costs nothing (n ids take exactly
// n * bits bits), with 3 bits 10 ids fill a word.
#ifndef AGAA_MATH_METADATA_GLSL
#define AGAA_MATH_METADATA_GLSL
#include "real.glsl"

// ceil(log2(c)); one aggregate needs no id.
uint agaa_bitsPerAggregateId(uint c) {
    uint bits = 0u;
    uint reach = 1u;
    while (reach < c && bits < 31u) {
        reach = reach << 1u;
        bits = bits + 1u;
    }
    return bits;
}

uint agaa_aggregateIdMask(uint bits) {
    return (1u << min(bits, 31u)) - 1u;
}

uint agaa_metadataWord(uint index, uint bits) {
    return bits == 0u ? 0u : index / (32u / bits);
}

uint agaa_metadataShift(uint index, uint bits) {
    return bits == 0u ? 0u : (index % (32u / bits)) * bits;
}

// bits as agaa_bitsPerAggregateId gives them, at most 3; index at most 31.
void agaa_packAggregateId(INOUT(uvec4) words, uint index, uint bits, uint id) {
    const uint mask = agaa_aggregateIdMask(bits);
    const uint word = agaa_metadataWord(index, bits);
    const uint shift = agaa_metadataShift(index, bits);
    const uint keep = ~(mask << shift);
    const uint put = (id & mask) << shift;
    if (word == 0u) {
        words.x = (words.x & keep) | put;
    } else if (word == 1u) {
        words.y = (words.y & keep) | put;
    } else if (word == 2u) {
        words.z = (words.z & keep) | put;
    } else {
        words.w = (words.w & keep) | put;
    }
}

uint agaa_unpackAggregateId(uvec4 words, uint index, uint bits) {
    const uint word = agaa_metadataWord(index, bits);
    uint value = words.w;
    if (word == 0u) {
        value = words.x;
    } else if (word == 1u) {
        value = words.y;
    } else if (word == 2u) {
        value = words.z;
    }
    return (value >> agaa_metadataShift(index, bits)) & agaa_aggregateIdMask(bits);
}

#endif
