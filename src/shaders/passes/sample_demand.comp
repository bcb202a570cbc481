// Counts, by their difference, the samples that the geometry of all pixels calls for, so that a limit can be found at which
// no more are shaded than the target allows.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#define AGAA_COUNTING 0
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "passes/display.glsl"
#include "passes/sample_choice.glsl"
#include "passes/stored_choice.glsl"
#include "passes/tile_pixels.glsl"

shared uint agaa_groupBins[129]; // and of pixels with geometry

void agaa_countDemand(uvec2 pixel) {
    uint covered = agaa_beginChoice(pixel);
    if (covered == 0u)
        return;
    atomicAdd(agaa_groupBins[agaa_coveredPixels], 1u);
    uint chosen = 1u << agaa_firstInOrder(covered);
    uint turn = 0u;
    do {
        if (chosen == covered)
            break;
        uint next = agaa_farthestSample(covered, chosen);
        if (!(agaa_distances[next] > agaa_leastDifference()))
            break;
        atomicAdd(agaa_groupBins[agaa_differenceBin(agaa_distances[next])], 1u);
        chosen |= 1u << next;
        agaa_chooseSample(pixel, covered, next);
    } while (++turn < agaa_sampleCount());
}

void main() {
    const uint lane = gl_LocalInvocationIndex;
    for (uint i = lane; i < 129u; i += 64u)
        agaa_groupBins[i] = 0u;
    barrier();
    uvec2 pixel = agaa_pixelOf(lane);
    if (all(lessThan(pixel, agaa_frame.size.xy)))
        agaa_countDemand(pixel);
    barrier();
    for (uint i = lane; i < 129u; i += 64u)
        if (agaa_groupBins[i] != 0u)
            atomicAdd(agaa_choices.words[i], agaa_groupBins[i]);
}
