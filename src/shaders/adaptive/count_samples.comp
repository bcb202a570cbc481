// Counts the samples that the geometry of listed pixels demands. Plans have this pass if neighbours or limits need the
// counts before samples are shaded.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/display.glsl"
#include "adaptive/sample_choice.glsl"
#include "adaptive/choose_more.glsl"
#include "adaptive/listed_pixels.glsl"

void main() {
    agaa_countBegin();
    const uint lane = gl_LocalInvocationIndex;
    uvec2 pixel = agaa_pixelAt(lane, agaa_listAt(agaa_boundedListIndexOf(lane)), AGAA_COMPLEX_PIXELS_AT);
    if (all(lessThan(pixel, agaa_frame.size))) {
        uint covered = agaa_beginChoice(pixel);
        float left;
        uint chosen = agaa_chooseMore(pixel, covered, 1u << agaa_firstInOrder(covered), 0u, 0.0, left);
        agaa_choices.words[agaa_choiceAt(pixel)] =
            agaa_packCount(uint(bitCount(covered)), uint(bitCount(chosen)), left);
    }
    agaa_countEnd();
}
