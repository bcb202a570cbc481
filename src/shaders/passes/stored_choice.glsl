// What passes of `adaptive` leave to later ones: sums over all pixels, and the choice of samples of each.
#ifndef AGAA_STORED_CHOICE_GLSL
#define AGAA_STORED_CHOICE_GLSL
#include "math/adaptive.glsl"

// Sums; then of each pixel a bit for each sample that shows geometry and the owners of all samples; then, with a memory, the
// mean count of each pixel; then, of sorted pixels, counts and ranks, and the pixels in order.
layout(std430, AGAA_AT_FRAGMENTS) buffer agaa_ChoiceBlock {
    uint words[];
} agaa_choices;

// Places of sums. Samples that would be shaded next, by agaa_differenceBin(), are the first.
const uint agaa_coveredPixels = 128u, agaa_geometryEvents = 129u;
const uint agaa_limitBits = 130u, agaa_shadingLimit = 131u; // a difference in thresholds; a bin
const uint agaa_tally = 132u;          // of pixels by count, [0, 32]
const uint agaa_shadingDemand = 192u;  // samples by agaa_demandBin()
const uint agaa_sumWords = 320u;

const uint agaa_ownerBits = AGAA_SAMPLES > 16u ? 5u : 4u;
const uint agaa_ownersPerWord = 32u / agaa_ownerBits;
const uint agaa_choiceWords = 1u + (AGAA_SAMPLES + agaa_ownersPerWord - 1u) / agaa_ownersPerWord;

uint agaa_pixelIndex(uvec2 pixel) { return pixel.y * agaa_frame.size.x + pixel.x; }
uint agaa_pixelCount() { return agaa_frame.size.x * agaa_frame.size.y; }
uint agaa_choiceAt(uvec2 pixel) { return agaa_sumWords + agaa_pixelIndex(pixel) * agaa_choiceWords; }
uint agaa_afterChoices() { return agaa_sumWords + agaa_pixelCount() * agaa_choiceWords; }
uint agaa_meanAt(uvec2 pixel) { return agaa_afterChoices() + agaa_pixelIndex(pixel); }
uint agaa_rankAt(uint index) { return agaa_afterChoices() + (AGAA_COUNT_MEMORY != 0u ? agaa_pixelCount() : 0u) + index; }
uint agaa_sortedAt(uint place) { return agaa_rankAt(agaa_pixelCount()) + place; }

// Differences that call for a further sample, in thresholds.
float agaa_differenceLimit() {
    return AGAA_TARGET_EVENTS != 0u ? uintBitsToFloat(agaa_choices.words[agaa_limitBits]) : 1.0;
}

// Whether samples that the shading calls for are shaded. further: how many it calls for in the pixel.
bool agaa_hasRoomFor(float further) {
    return AGAA_TARGET_EVENTS == 0u || agaa_demandBin(further) >= agaa_choices.words[agaa_shadingLimit];
}
#endif
