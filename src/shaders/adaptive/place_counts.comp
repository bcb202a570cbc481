// Finds the index of the first pixel of each number of samples in the sorted list. The largest number comes first.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "adaptive/stored_choice.glsl"

void main() {
    if (gl_LocalInvocationIndex != 0u)
        return;
    uint sum = 0u;
    for (uint count = AGAA_TALLIES; count != 0u; --count) {
        uint pixels = agaa_choices.words[AGAA_TALLY_AT + count - 1u];
        agaa_choices.words[AGAA_TALLY_AT + count - 1u] = sum;
        sum += pixels;
    }
}
