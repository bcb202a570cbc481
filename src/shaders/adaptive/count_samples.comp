// Counts the samples that the geometry of listed pixels demands. Plans have this pass if neighbours or limits need the
// counts before samples are shaded.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/subgroup_extensions.glsl"
#if AGAA_SAMPLE_LANES
layout(local_size_x = 64) in; // full subgroups
#else
layout(local_size_x = 8, local_size_y = 8) in;
#endif
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "math/display.glsl"
#include "adaptive/sample_choice.glsl"
#include "adaptive/choose_more.glsl"
#include "adaptive/listed_pixels.glsl"

uvec2 agaa_pixelOf(uint lane) {
    return agaa_pixelAt(lane, agaa_listAt(agaa_boundedListIndexOf(lane)), AGAA_COMPLEX_PIXELS_AT);
}

void agaa_writeChoice(uvec2 pixel, uint covered, uint chosen, float left) {
    agaa_choices.words[agaa_choiceAt(pixel)] = agaa_packCount(uint(bitCount(covered)), uint(bitCount(chosen)), left);
}

void main() {
    agaa_countBegin();
    float left;
#if AGAA_SAMPLE_LANES
    for (uint iteration = 0u; iteration < agaa_pixelLanes; ++iteration) {
        uvec2 pixel = agaa_pixelOf(agaa_lanePixel(iteration));
        agaa_LaneChoice c = agaa_beginLaneChoice(pixel);
        uint chosen = agaa_chooseMore(c, pixel, 0u, 0.0, left);
        if (agaa_laneSample() == 0u && all(lessThan(pixel, agaa_frame.size)))
            agaa_writeChoice(pixel, c.sample_.covered, chosen, left);
    }
#else
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    if (all(lessThan(pixel, agaa_frame.size))) {
        uint covered = agaa_beginChoice(pixel);
        uint chosen = agaa_chooseMore(pixel, covered, 1u << agaa_firstInOrder(covered), 0u, 0.0, left);
        agaa_writeChoice(pixel, covered, chosen, left);
    }
#endif
    agaa_countEnd();
}
