// Chooses the samples of a mask at which shadows are looked up, evenly. A loop over the chosen samples has fewer
// iterations than a loop over all samples in which lanes skip different ones.
#ifndef AGAA_SHADOW_TAPS_GLSL
#define AGAA_SHADOW_TAPS_GLSL
#include "tables/lighting.inc"

struct agaa_Choice {
    uint left;  // samples from the last returned one on
    uint seen;  // number of samples before it
    uint count; // number of all samples
    uint wanted;
};

// wanted   Number of samples to choose, at most the number of bits of the mask.
agaa_Choice agaa_chooseFrom(uint mask, uint wanted) {
    return agaa_Choice(mask, 0u, uint(bitCount(mask)), wanted);
}

// Returns chosen sample j, which is sample floor((j + 1/2) count / wanted) of the mask. Calls must have ascending j.
uint agaa_nextSample(inout agaa_Choice choice, uint j) {
    if (AGAA_SHADOW_FILTER != AGAA_SHADOW_AT_MEAN && AGAA_SAMPLES <= AGAA_SHADOW_TAPS) { // all samples are chosen
        uint next = uint(findLSB(choice.left));
        choice.left &= choice.left - 1u;
        return next;
    }
    uint next = (2u * j + 1u) * choice.count / (2u * choice.wanted);
    for (; choice.seen < next; ++choice.seen)
        choice.left &= choice.left - 1u;
    return uint(findLSB(choice.left));
}
#endif
