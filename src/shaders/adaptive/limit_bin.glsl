// The lowest bin of a histogram whose samples are shaded. Needs common/frame.glsl.
#ifndef AGAA_LIMIT_BIN_GLSL
#define AGAA_LIMIT_BIN_GLSL
#include "adaptive/stored_choice.glsl"

// Returns the lowest bin such that the samples of this and all higher bins do not exceed `room`; agaa_bins() if there
// is none.
// first   Index of the word of the first bin.
uint agaa_limitBin(uint first, float room) {
    uint bin = agaa_bins();
    uint sum = 0u;
    while (bin != 0u && float(sum + agaa_choices.words[first + bin - 1u]) <= room) {
        --bin;
        sum += agaa_choices.words[first + bin];
    }
    return bin;
}
#endif
