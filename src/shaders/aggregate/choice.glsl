// Some samples of many, evenly chosen. A loop over the chosen ones does its work as often as there are such, where
// one over all samples, lanes skipping different ones, does it for each.
#ifndef AGAA_CHOICE_GLSL
#define AGAA_CHOICE_GLSL
#include "tables/lighting.inc"

struct agaa_Choice {
    uint left;  // samples from the last one taken on
    uint seen;  // samples before it
    uint count; // of all
    uint wanted;
};

// wanted: at most as many as there are.
agaa_Choice agaa_chooseFrom(uint mask, uint wanted) {
    return agaa_Choice(mask, 0u, uint(bitCount(mask)), wanted);
}

// The one chosen as number j: sample floor((j + 1/2) count / wanted) of the mask. j ascends.
uint agaa_nextSample(inout agaa_Choice choice, uint j) {
    if (AGAA_SHADOW_FILTER != AGAA_SHADOW_AT_MEAN && AGAA_SAMPLES <= AGAA_SHADOW_TAPS) { // as many are wanted as there are
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
