// Makes a histogram of the samples that the geometry of all pixels demands, by their difference. The next pass finds
// the limit by which no more samples are shaded than the target allows.
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
#include "adaptive/stored_choice.glsl"
#include "common/tile_pixels.glsl"

shared uint agaa_groupDifferences[AGAA_BINS]; // number of samples by bin
shared uint agaa_groupCovered;

#if AGAA_SAMPLE_LANES
// Counts the demand of the pixel of this lane, which may be outside the image. All lanes call it.
void agaa_countLaneDemand(uvec2 pixel) {
    agaa_LaneChoice c = agaa_beginLaneChoice(pixel);
    const uint covered = c.sample_.covered;
    const bool counts = agaa_laneSample() == 0u;
    if (counts && covered != 0u)
        atomicAdd(agaa_groupCovered, 1u);
    uint chosen = covered != 0u ? 1u << c.sample_.first : 0u;
    bool isChoosing = true;
    for (uint iteration = 0u; iteration < AGAA_SAMPLES; ++iteration) {
        isChoosing = isChoosing && chosen != covered;
        if (!agaa_anyLane(isChoosing))
            break;
        float most;
        uint next = agaa_farthestOfLanes(c, chosen, most);
        isChoosing = isChoosing && most > agaa_leastDifference();
        if (counts && isChoosing)
            atomicAdd(agaa_groupDifferences[agaa_differenceBin(most)], 1u);
        chosen |= isChoosing ? 1u << next : 0u;
        agaa_chooseLane(c, pixel, isChoosing, next);
    }
}

void agaa_countTile() {
    for (uint iteration = 0u; iteration < agaa_pixelLanes; ++iteration)
        agaa_countLaneDemand(agaa_pixelOf(agaa_lanePixel(iteration)));
}
#else
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

void agaa_countTile() {
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    if (all(lessThan(pixel, agaa_frame.size)))
        agaa_countDemand(pixel);
}
#endif

void main() {
    agaa_countBegin();
    const uint lane = gl_LocalInvocationIndex;
    for (uint i = lane; i < agaa_bins(); i += 64u)
        agaa_groupDifferences[i] = 0u;
    if (lane == 0u)
        agaa_groupCovered = 0u;
    barrier();
    agaa_countTile();
    barrier();
    for (uint i = lane; i < agaa_bins(); i += 64u)
        if (agaa_groupDifferences[i] != 0u)
            atomicAdd(agaa_choices.words[AGAA_DIFFERENCES_AT + i], agaa_groupDifferences[i]);
    if (lane == 0u && agaa_groupCovered != 0u)
        atomicAdd(agaa_choices.words[AGAA_COVERED_PIXELS_AT], agaa_groupCovered);
    agaa_countEnd();
}
