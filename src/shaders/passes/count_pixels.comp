// Decides numbers of samples, and counts pixels by these: the first of three passes that sort pixels.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/decide_count.glsl"
#include "passes/tile_pixels.glsl"

void main() {
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool isInside = all(lessThan(pixel, agaa_frame.size.xy));
    uint count = agaa_decideCount(pixel, isInside);
    if (isInside)
        agaa_choices.words[agaa_rankAt(agaa_pixelIndex(pixel))] =
            count << AGAA_RANK_BITS | atomicAdd(agaa_choices.words[AGAA_TALLY_AT + count], 1u);
}
