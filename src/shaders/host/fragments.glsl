// Fragments pass: appends the coverage of each fragment, with the id of its primitive or its material, to the list of
// its pixel. Needs AGAA_STORAGE_IMAGES, AGAA_NEEDS_MATERIAL, and what coverage/append_fragment.glsl needs.
// Source: Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, section 3.1.
#if !defined(AGAA_STORAGE_IMAGES) || !defined(AGAA_NEEDS_MATERIAL)
#error "fragments.glsl needs AGAA_STORAGE_IMAGES and AGAA_NEEDS_MATERIAL."
#endif
#include "host/fragment_depth.glsl"

#if AGAA_STORAGE_IMAGES
layout(r32ui, AGAA_BINDING_FRAGMENTS) uniform uimageBuffer agaa_fragments;
uint agaa_readFragments(uint word) { return imageLoad(agaa_fragments, int(word)).x; }
uint agaa_addToFragments(uint word, uint amount) { return imageAtomicAdd(agaa_fragments, int(word), amount); }
uint agaa_exchangeFragments(uint word, uint value) { return imageAtomicExchange(agaa_fragments, int(word), value); }
uint agaa_lowerFragments(uint word, uint value) { return imageAtomicMin(agaa_fragments, int(word), value); }
uint agaa_raiseFragments(uint word, uint value) { return imageAtomicMax(agaa_fragments, int(word), value); }
void agaa_setFragments(uint word, uint value) { imageStore(agaa_fragments, int(word), uvec4(value)); }
#else
layout(std430, AGAA_BINDING_FRAGMENTS) buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;
uint agaa_readFragments(uint word) { return agaa_fragments.words[word]; }
uint agaa_addToFragments(uint word, uint amount) { return atomicAdd(agaa_fragments.words[word], amount); }
uint agaa_exchangeFragments(uint word, uint value) { return atomicExchange(agaa_fragments.words[word], value); }
uint agaa_lowerFragments(uint word, uint value) { return atomicMin(agaa_fragments.words[word], value); }
uint agaa_raiseFragments(uint word, uint value) { return atomicMax(agaa_fragments.words[word], value); }
void agaa_setFragments(uint word, uint value) { agaa_fragments.words[word] = value; }
#endif
uint agaa_listCapacity() { return agaa_fragmentCapacity(); }
#include "coverage/append_fragment.glsl"

void agaa_emit(AgaaSurfaceInput s) {
    uvec4 mask = agaa_coverageOf(s);
    if (agaa_coverageCount(mask) == 0u || AGAA_HELPER)
        return;
    agaa_DepthPlane plane = agaa_cornerPlane();
#if AGAA_NEEDS_MATERIAL
    if (!agaa_packFragment(s, mask, plane))
        return;
#endif
    uint record = agaa_appendFragment(agaa_hostPixel(), agaa_orderOfInput(s), mask, plane);
#if AGAA_NEEDS_MATERIAL
    if (agaa_isFirstDraw())
        agaa_countSurface(agaa_wasSanitised);
    for (uint word = 0u; word < AGAA_MATERIAL_PAYLOAD_WORDS && record != 0u; ++word)
        agaa_setFragments(record + AGAA_FRAGMENT_MASK_AT + AGAA_SAMPLES / 32u + word, agaa_payload[word]);
#else
    if (agaa_isFirstDraw())
        agaa_countMask(s);
#endif
}
