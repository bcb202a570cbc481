// Packs the spread of a surface's normals, which elliptic lobes use, in two words. AGAA_SPREAD_WORDS is then 2, else 0.
// Needs AGAA_SAMPLES and AGAA_SPREAD_WORDS, which common/constants.glsl has.
#ifndef AGAA_SURFACE_SPREAD_GLSL
#define AGAA_SURFACE_SPREAD_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && (!defined(AGAA_SAMPLES) || !defined(AGAA_SPREAD_WORDS))
#error "surface_spread.glsl needs AGAA_SAMPLES and AGAA_SPREAD_WORDS."
#endif
#include "math/coverage_pattern.glsl"
#include "math/normal_spread.glsl"
#include "coverage/packed_normals.glsl"

uvec2 agaa_packSpread(agaa_NormalSpread s) {
    return uvec2(agaa_packBfloats(s.moments.xy), agaa_packBfloats(vec2(s.moments.z, s.meanLength)));
}

agaa_NormalSpread agaa_unpackSpread(vec3 normal, uvec2 words) {
    vec2 last = agaa_unpackBfloats(words.y);
    return agaa_NormalSpread(normal, vec3(agaa_unpackBfloats(words.x), last.x), last.y);
}

// Returns the spread of a fragment's normals over the samples that it covers.
agaa_NormalSpread agaa_spreadOfFragment(vec3 normal, vec3 dx, vec3 dy, uvec4 mask) {
    if (dx == vec3(0.0) && dy == vec3(0.0))
        return agaa_noSpread(normal);
    vec2 middle = agaa_coverageMiddle(mask, AGAA_SAMPLES);
    vec3 products = vec3(0.0);
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        for (uint left = mask[word]; left != 0u; left &= left - 1u) {
            vec2 offset = agaa_coveragePosition(word * 32u + uint(findLSB(left)), AGAA_SAMPLES) - middle;
            products += vec3(offset * offset, offset.x * offset.y);
        }
    return agaa_spreadOfChange(normal, dx, dy, products / float(agaa_coverageCount(mask)));
}
#endif
