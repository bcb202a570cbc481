// The buffer that passes of `adaptive` share: sums over all pixels, a word for each pixel, and lists of pixels. Needs
// common/frame.glsl and AGAA_BINDING_CHOICES.
#ifndef AGAA_STORED_CHOICE_GLSL
#define AGAA_STORED_CHOICE_GLSL
#if !defined(AGAA_FRAME_GLSL) || !defined(AGAA_BINDING_CHOICES)
#error "stored_choice.glsl needs frame.glsl and AGAA_BINDING_CHOICES."
#endif
#include "adaptive/adaptive_flags.glsl"
#include "math/adaptive.glsl"
#include "tables/choice_words.inc"

layout(std430, AGAA_BINDING_CHOICES) buffer agaa_ChoiceBlock {
    uint words[];
} agaa_choices;

uint agaa_pixelIndex(uvec2 pixel) { return pixel.y * agaa_frame.size.x + pixel.x; }
uint agaa_pixelCount() { return agaa_frame.size.x * agaa_frame.size.y; }
// The following functions return indices of words. The choice of a pixel is agaa_packCount(); the choice of a listed
// pixel determines the number of its samples.
uint agaa_choiceAt(uvec2 pixel) { return AGAA_SUM_WORDS + agaa_pixelIndex(pixel); }
uint agaa_listAt(uint index) { return AGAA_SUM_WORDS + agaa_pixelCount() + index; }
uint agaa_meanAt(uvec2 pixel) { return agaa_listAt(agaa_pixelCount()) + agaa_pixelIndex(pixel); }
uint agaa_rankAt(uint index) {
    return agaa_listAt(agaa_pixelCount()) + (AGAA_COUNT_MEMORY != 0u ? agaa_pixelCount() : 0u) + index;
}
uint agaa_sortedAt(uint index) { return agaa_rankAt(agaa_pixelCount()) + index; }
// word: of the pixel; each has the light of four samples.
uint agaa_lightAt(uvec2 pixel, uint word) {
    uint begin = agaa_isAdaptive(AGAA_ADAPTIVE_SORTED) ? agaa_sortedAt(agaa_pixelCount()) : agaa_rankAt(0u);
    return begin + agaa_pixelIndex(pixel) * ((AGAA_SAMPLES + 3u) / 4u) + word;
}

// Returns whether a sample is shaded. difference: in thresholds, from all samples that are shaded.
bool agaa_callsForSample(float difference) {
    if (AGAA_TARGET_EVENTS == 0u)
        return difference > 1.0;
    return difference > agaa_leastDifference() &&
           agaa_differenceBin(difference) >= agaa_choices.words[AGAA_DIFFERENCE_LIMIT_AT];
}

// Returns the lowest difference of a sample that is shaded.
float agaa_differenceLimit() {
    return AGAA_TARGET_EVENTS == 0u ? 1.0 : agaa_differenceOfBin(agaa_choices.words[AGAA_DIFFERENCE_LIMIT_AT]);
}

// Returns a difference as a share of the limit, [0, 1].
float agaa_shareOfLimit(float difference) { return clamp(difference / agaa_differenceLimit(), 0.0, 1.0); }

// Returns whether samples that shading demands are shaded. further: their number in the pixel.
bool agaa_hasRoomFor(float further) {
    return AGAA_TARGET_EVENTS == 0u || agaa_demandBin(further) >= agaa_choices.words[AGAA_DEMAND_LIMIT_AT];
}
#endif
