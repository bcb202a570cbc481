// Custom channels that are not averaged: the class of a material (AGAA_FILTER_CLASS), and those of AGAA_FILTER_NONE.
#ifndef AGAA_CUSTOM_FILTERS_GLSL
#define AGAA_CUSTOM_FILTERS_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && !defined(AGAA_CLASS_CHANNEL)
#error "custom_filters.glsl needs AGAA_CLASS_CHANNEL and AGAA_UNFILTERED_CHANNELS."
#endif
#include "common/stored.glsl"

// Returns 0 if the layout has no classes.
uint agaa_classOf(agaa_Stored v) {
    return AGAA_CLASS_CHANNEL != 0u ? agaa_quantise(v.custom[max(AGAA_CLASS_CHANNEL, 1u) - 1u], 8u) : 0u;
}

// Adds a class to the vote for the class of an aggregate: the majority vote of Boyer and Moore 1991, with weights. It
// finds the class of more than half of the samples; without such a class, it finds one of the classes.
// margin   Weight by which the class leads.
void agaa_voteForClass(inout float class_, inout float margin, float other, float weight) {
    if (agaa_quantise(other, 8u) == agaa_quantise(class_, 8u)) {
        margin += weight;
    } else if (weight > margin) {
        class_ = other;
        margin = weight - margin;
    } else {
        margin -= weight;
    }
}

bool agaa_isUnfilteredChannel(uint i) { return (AGAA_UNFILTERED_CHANNELS >> i & 1u) != 0u; }

// Returns whether channel i of an unfiltered attribute is taken from another surface. Call it for the channels in their
// order.
// order   0: the attribute's channels so far are equal, 1: those of the other surface are larger, 2: smaller.
bool agaa_takesUnfiltered(inout uint order, uint i, float kept, float other) {
    bool begins = (AGAA_UNFILTERED_CHANNELS >> 8u + i & 1u) != 0u;
    order = begins ? 0u : order;
    if (order == 0u && other != kept)
        order = other > kept ? 1u : 2u;
    return order == 1u;
}
#endif
