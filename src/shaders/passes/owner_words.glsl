// The choice of a pixel's samples, from and to memory.
#ifndef AGAA_OWNER_WORDS_GLSL
#define AGAA_OWNER_WORDS_GLSL
#include "passes/sample_choice.glsl"
#include "passes/stored_choice.glsl"

void agaa_storeChoice(uvec2 pixel, uint covered) {
    const uint at = agaa_choiceAt(pixel);
    agaa_choices.words[at] = covered;
    uint word = 1u;
    uint i = 0u;
    do {
        uint owners = 0u;
        for (uint shift = 0u; shift + agaa_ownerBits <= 32u; shift += agaa_ownerBits) {
            owners |= i < AGAA_SAMPLES && (covered >> i & 1u) != 0u ? agaa_owners[min(i, AGAA_SAMPLES - 1u)] << shift : 0u;
            ++i;
        }
        agaa_choices.words[at + word] = owners;
    } while (++word < agaa_choiceWords);
}

// Returns the samples that show geometry.
uint agaa_loadChoice(uvec2 pixel, out uint chosen) {
    const uint at = agaa_choiceAt(pixel);
    const uint covered = agaa_choices.words[at];
    chosen = 0u;
    uint i = 0u;
    do {
        uint word = agaa_choices.words[at + 1u + i / agaa_ownersPerWord];
        agaa_owners[i] = word >> (agaa_ownerBits * (i % agaa_ownersPerWord)) & ((1u << agaa_ownerBits) - 1u);
        chosen |= (covered >> i & 1u) != 0u ? 1u << agaa_owners[i] : 0u;
    } while (++i < agaa_sampleCount());
    return covered;
}
#endif
