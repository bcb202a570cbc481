// Writes the listed pixels in sorted order.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "adaptive/listed_pixels.glsl"

void main() {
    uint index = agaa_listIndexOf(gl_LocalInvocationIndex);
    if (index >= agaa_choices.words[AGAA_FURTHER_AT])
        return;
    uint word = agaa_choices.words[agaa_rankAt(index)];
    uint sorted = agaa_choices.words[AGAA_TALLY_AT + agaa_countOfRank(word)] + agaa_rankOf(word);
    agaa_choices.words[agaa_sortedAt(sorted)] = agaa_choices.words[agaa_listAt(index)];
}
