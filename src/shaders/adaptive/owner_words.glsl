// The owners of a pixel's samples in words of shared memory.
#ifndef AGAA_OWNER_WORDS_GLSL
#define AGAA_OWNER_WORDS_GLSL
#include "adaptive/sample_choice.glsl"

const uint agaa_ownerBits = AGAA_SAMPLES > 16u ? 5u : 4u;
const uint agaa_ownersPerWord = 32u / agaa_ownerBits;
const uint agaa_ownerWords = (AGAA_SAMPLES + agaa_ownersPerWord - 1u) / agaa_ownersPerWord;

uint agaa_ownerIn(uint word, uint place) {
    return word >> (agaa_ownerBits * place) & ((1u << agaa_ownerBits) - 1u);
}

// The owners of the samples of a word.
uint agaa_ownerWord(uint word, uint covered) {
    uint owners = 0u;
    for (uint place = 0u; place < agaa_ownersPerWord; ++place) {
        uint i = min(word * agaa_ownersPerWord + place, AGAA_SAMPLES - 1u);
        owners |= (covered >> i & 1u) != 0u ? agaa_owners[i] << (agaa_ownerBits * place) : 0u;
    }
    return owners;
}
#endif
