// The surfaces of the current pixel in shared memory, for math/surface_merge.glsl. On GPUs an array of a lane that is
// accessed by a variable index is in device memory. A surface has the words that it has in memory
// (coverage/covered_surface.glsl) without its material, and the depth at its anchor, which takes long to find. It is
// thus rounded when it is kept. Only the current fragment is not rounded.
#ifndef AGAA_SHARED_SURFACES_GLSL
#define AGAA_SHARED_SURFACES_GLSL
#include "coverage/covered_surface.glsl"

const uint agaa_sharedWords = AGAA_MASK_WORDS + AGAA_SHARED_PLANE_WORDS;
shared uint agaa_sharedSurfaces[64u * AGAA_AGGREGATES * agaa_sharedWords];
agaa_CoveredSurface agaa_currentFragment;

// Lanes that access the same word use different banks of the memory.
#define AGAA_SHARED_WORD(surface, word) \
    agaa_sharedSurfaces[64u * ((surface) * agaa_sharedWords + (word)) + gl_LocalInvocationIndex]

void agaa_keep(uint i, agaa_CoveredSurface s) {
    if (i == agaa_aggregateLimit()) {
        agaa_currentFragment = s;
        return;
    }
    vec2 anchor = agaa_coverageMiddle(s.mask, AGAA_SAMPLES);
    agaa_StoredPlane stored = agaa_storePlane(s.plane, s.depths, anchor);
    for (uint word = 0u; word < AGAA_MASK_WORDS; ++word)
        AGAA_SHARED_WORD(i, word) = s.mask[word];
    AGAA_SHARED_WORD(i, AGAA_DEPTH_WORD) = floatBitsToUint(stored.depth);
    AGAA_SHARED_WORD(i, AGAA_SLOPE_WORD) = stored.slopes;
    AGAA_SHARED_WORD(i, AGAA_NORMAL_WORD) = agaa_packNormal(s.normal);
    AGAA_SHARED_WORD(i, AGAA_NORMAL_WORD + 1u) = floatBitsToUint(agaa_storedDepths(stored, anchor).x);
}

agaa_CoveredSurface agaa_keptAt(uint i) {
    if (i == agaa_aggregateLimit())
        return agaa_currentFragment;
    uvec4 mask = uvec4(0u);
    for (uint word = 0u; word < AGAA_MASK_WORDS; ++word)
        mask[word] = AGAA_SHARED_WORD(i, word);
    agaa_StoredPlane stored = agaa_StoredPlane(uintBitsToFloat(AGAA_SHARED_WORD(i, AGAA_DEPTH_WORD)),
                                               AGAA_SHARED_WORD(i, AGAA_SLOPE_WORD));
    return agaa_CoveredSurface(
        mask, agaa_storedPlane(stored),
        vec3(uintBitsToFloat(AGAA_SHARED_WORD(i, AGAA_NORMAL_WORD + 1u)), agaa_storedSides(stored)),
        agaa_unpackNormal(AGAA_SHARED_WORD(i, AGAA_NORMAL_WORD)));
}

void agaa_storeKept(uint base, uint i) {
    for (uint word = 0u; word < AGAA_MASK_WORDS + AGAA_PLANE_WORDS; ++word)
        agaa_setSurfaces(base + word, AGAA_SHARED_WORD(i, word));
}
#endif
