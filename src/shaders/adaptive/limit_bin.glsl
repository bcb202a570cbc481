// From which bin of a histogram on its samples are shaded.
#ifndef AGAA_LIMIT_BIN_GLSL
#define AGAA_LIMIT_BIN_GLSL
#include "adaptive/stored_choice.glsl"

// The least bin at which the samples of this and all larger ones are no more than there is room for; agaa_bins() where there is
// none. first: the place of the first bin.
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
