// The choice of a pixel's samples, from and to memory.
#ifndef AGAA_OWNER_WORDS_GLSL
#define AGAA_OWNER_WORDS_GLSL
#include "passes/sample_choice.glsl"
#include "passes/stored_choice.glsl"

const uint agaa_ownersPerWord = 32u / AGAA_OWNER_BITS(AGAA_SAMPLES);

uint agaa_ownerIn(uint word, uint place) {
    return word >> (AGAA_OWNER_BITS(AGAA_SAMPLES) * place) & ((1u << AGAA_OWNER_BITS(AGAA_SAMPLES)) - 1u);
}

// The owners of the samples of a word.
uint agaa_ownerWord(uint word, uint covered) {
    uint owners = 0u;
    for (uint place = 0u; place < agaa_ownersPerWord; ++place) {
        uint i = min(word * agaa_ownersPerWord + place, AGAA_SAMPLES - 1u);
        owners |= (covered >> i & 1u) != 0u ? agaa_owners[i] << (AGAA_OWNER_BITS(AGAA_SAMPLES) * place) : 0u;
    }
    return owners;
}

void agaa_storeChoice(uvec2 pixel, uint covered) {
    const uint at = agaa_choiceAt(pixel);
    agaa_choices.words[at] = covered;
    uint word = 0u;
    do
        agaa_choices.words[at + 1u + word] = agaa_ownerWord(word, covered);
    while (++word < AGAA_OWNER_WORDS(AGAA_SAMPLES));
}

// Returns the samples that show geometry.
uint agaa_loadChoice(uvec2 pixel, out uint chosen) {
    const uint at = agaa_choiceAt(pixel);
    const uint covered = agaa_choices.words[at];
    chosen = 0u;
    uint i = 0u;
    do {
        agaa_owners[i] = agaa_ownerIn(agaa_choices.words[at + 1u + i / agaa_ownersPerWord], i % agaa_ownersPerWord);
        chosen |= (covered >> i & 1u) != 0u ? 1u << agaa_owners[i] : 0u;
    } while (++i < agaa_sampleCount());
    return covered;
}
#endif
