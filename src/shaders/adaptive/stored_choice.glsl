// What passes of `adaptive` leave to later ones: sums over all pixels, a word of each pixel, and lists of pixels.
#ifndef AGAA_STORED_CHOICE_GLSL
#define AGAA_STORED_CHOICE_GLSL
#include "math/adaptive.glsl"
#include "tables/choice_words.inc"

layout(std430, AGAA_BINDING_CHOICES) buffer agaa_ChoiceBlock {
    uint words[];
} agaa_choices;

uint agaa_pixelIndex(uvec2 pixel) { return pixel.y * agaa_frame.size.x + pixel.x; }
uint agaa_pixelCount() { return agaa_frame.size.x * agaa_frame.size.y; }
// agaa_packCount() of the pixel; of a listed one, what its number of samples follows from.
uint agaa_choiceAt(uvec2 pixel) { return AGAA_SUM_WORDS + agaa_pixelIndex(pixel); }
uint agaa_listAt(uint place) { return AGAA_SUM_WORDS + agaa_pixelCount() + place; }
uint agaa_meanAt(uvec2 pixel) { return agaa_listAt(agaa_pixelCount()) + agaa_pixelIndex(pixel); }
uint agaa_rankAt(uint place) { return agaa_listAt(agaa_pixelCount()) + (AGAA_COUNT_MEMORY != 0u ? agaa_pixelCount() : 0u) + place; }
uint agaa_sortedAt(uint place) { return agaa_rankAt(agaa_pixelCount()) + place; }

// Whether a sample that differs by so many thresholds from all shaded ones is shaded, too.
bool agaa_callsForSample(float difference) {
    if (AGAA_TARGET_EVENTS == 0u)
        return difference > 1.0;
    return difference > agaa_leastDifference() &&
           agaa_differenceBin(difference) >= agaa_choices.words[AGAA_DIFFERENCE_LIMIT_AT];
}

// The least difference of such a sample.
float agaa_differenceLimit() {
    return AGAA_TARGET_EVENTS == 0u ? 1.0 : agaa_differenceOfBin(agaa_choices.words[AGAA_DIFFERENCE_LIMIT_AT]);
}

// A difference as a share of it.
float agaa_shareOfLimit(float difference) { return clamp(difference / agaa_differenceLimit(), 0.0, 1.0); }

// Whether samples that the shading calls for are shaded. further: how many it calls for in the pixel.
bool agaa_hasRoomFor(float further) {
    return AGAA_TARGET_EVENTS == 0u || agaa_demandBin(further) >= agaa_choices.words[AGAA_DEMAND_LIMIT_AT];
}
#endif
