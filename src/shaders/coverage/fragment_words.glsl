// The buffer of fragment lists. Needs common/frame.glsl and AGAA_BINDING_FRAGMENTS.
#ifndef AGAA_FRAGMENT_WORDS_GLSL
#define AGAA_FRAGMENT_WORDS_GLSL
#if !defined(AGAA_FRAME_GLSL) || !defined(AGAA_BINDING_FRAGMENTS)
#error "fragment_words.glsl needs frame.glsl and AGAA_BINDING_FRAGMENTS."
#endif
#include "coverage/fragment_layout.glsl"

#ifndef AGAA_LISTS_QUALIFIER
#define AGAA_LISTS_QUALIFIER // coherent if lanes read words that other lanes wrote
#endif
layout(std430, AGAA_BINDING_FRAGMENTS) AGAA_LISTS_QUALIFIER buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;
bool agaa_hasBatches() { return agaa_opaque(agaa_frame.maxBatches) > 1u; }
uint agaa_record(uint fragment) { return agaa_recordOf(fragment, agaa_frame.size, agaa_hasBatches()); }

uvec4 agaa_maskOf(uint record) {
    uvec4 mask = uvec4(0u);
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        mask[word] = agaa_fragments.words[record + AGAA_FRAGMENT_MASK_AT + word];
    return mask;
}

void agaa_setMask(uint record, uvec4 mask) {
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        agaa_fragments.words[record + AGAA_FRAGMENT_MASK_AT + word] = mask[word];
}

uint agaa_nextOf(uint record) { return agaa_fragments.words[record + AGAA_FRAGMENT_NEXT_AT]; }
void agaa_setNext(uint record, uint fragment) { agaa_fragments.words[record + AGAA_FRAGMENT_NEXT_AT] = fragment; }
#endif
