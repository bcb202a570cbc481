// Makes a histogram of the samples that the geometry of all pixels demands, by their difference. The next pass finds
// the limit by which no more samples are shaded than the target allows.
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
#include "adaptive/stored_choice.glsl"
#include "common/tile_pixels.glsl"

shared uint agaa_groupDifferences[AGAA_BINS]; // number of samples by bin
shared uint agaa_groupCovered;

void agaa_countDemand(uvec2 pixel) {
    uint covered = agaa_beginChoice(pixel);
    if (covered == 0u)
        return;
    atomicAdd(agaa_groupCovered, 1u);
    uint chosen = 1u << agaa_firstInOrder(covered);
    uint iteration = 0u;
    do {
        if (chosen == covered)
            break;
        uint next = agaa_farthestSample(covered, chosen);
        if (!(agaa_distances[next] > agaa_leastDifference()))
            break;
        atomicAdd(agaa_groupDifferences[agaa_differenceBin(agaa_distances[next])], 1u);
        chosen |= 1u << next;
        agaa_chooseSample(pixel, covered, next);
    } while (++iteration < agaa_sampleCount());
}

void main() {
    agaa_countBegin();
    const uint lane = gl_LocalInvocationIndex;
    for (uint i = lane; i < agaa_bins(); i += 64u)
        agaa_groupDifferences[i] = 0u;
    if (lane == 0u)
        agaa_groupCovered = 0u;
    barrier();
    uvec2 pixel = agaa_pixelOf(lane);
    if (all(lessThan(pixel, agaa_frame.size)))
        agaa_countDemand(pixel);
    barrier();
    for (uint i = lane; i < agaa_bins(); i += 64u)
        if (agaa_groupDifferences[i] != 0u)
            atomicAdd(agaa_choices.words[AGAA_DIFFERENCES_AT + i], agaa_groupDifferences[i]);
    if (lane == 0u && agaa_groupCovered != 0u)
        atomicAdd(agaa_choices.words[AGAA_COVERED_PIXELS_AT], agaa_groupCovered);
    agaa_countEnd();
}
