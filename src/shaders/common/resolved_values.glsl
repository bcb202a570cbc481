// The values of AgaaResolvedOutputs: words of each pixel that sum them over samples. core/plan/resolved_outputs.cpp
// writes the macros
//   AGAA_RESOLVED_WORDS                        number of words; word 0 counts samples
//   AGAA_ADD_VALUES(samples, normal, custom)   adds the surface of some samples; custom: as layouts store it
//   AGAA_ADD_DEPTHS(samples, depth)            adds their depth, if no depth buffer has it
// Includers define agaa_addToSum(word, amount) and agaa_raiseSum(word, least).
#ifndef AGAA_RESOLVED_VALUES_GLSL
#define AGAA_RESOLVED_VALUES_GLSL
#ifndef AGAA_RESOLVED_WORDS
#error "resolved_values.glsl needs AGAA_RESOLVED_WORDS."
#endif
#include "math/encoding.glsl"
#include "math/ordered_bits.glsl"
#include "math/pixel_sums.glsl"

// Returns a word that is greater for nearer depths, and never 0.
uint agaa_nearness(float depth) { return agaa_orderedBits(AGAA_FAR_DEPTH != 0u ? -depth : depth); }
float agaa_depthOfNearness(uint nearness) {
    float ordered = agaa_fromOrderedBits(nearness);
    return AGAA_FAR_DEPTH != 0u ? -ordered : ordered;
}
#endif
