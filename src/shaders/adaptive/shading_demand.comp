// Makes a histogram of the samples that the first samples demand beyond those of geometry.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "adaptive/first_samples.glsl"
#include "common/tile_pixels.glsl"

shared uint agaa_groupDemand[AGAA_BINS]; // number of samples by bin
shared uint agaa_groupEvents;            // number of samples by geometry

void main() {
    const uint lane = gl_LocalInvocationIndex;
    for (uint i = lane; i < agaa_bins(); i += 64u)
        agaa_groupDemand[i] = 0u;
    if (lane == 0u)
        agaa_groupEvents = 0u;
    barrier();
    uvec2 pixel = agaa_pixelOf(lane);
    uint word = 0u;
    if (all(lessThan(pixel, agaa_frame.size)))
        word = agaa_choices.words[agaa_choiceAt(pixel)];
    if (agaa_coveredIn(word) != 0u) {
        uint count = agaa_countIn(word);
        float further = agaa_furtherByShading(agaa_countByShading(pixel), count, agaa_leftIn(word));
        atomicAdd(agaa_groupEvents, count);
        atomicAdd(agaa_groupDemand[agaa_demandBin(further)], agaa_withFurther(count, further) - count);
    }
    barrier();
    for (uint i = lane; i < agaa_bins(); i += 64u)
        if (agaa_groupDemand[i] != 0u)
            atomicAdd(agaa_choices.words[AGAA_DEMAND_AT + i], agaa_groupDemand[i]);
    if (lane == 0u)
        atomicAdd(agaa_choices.words[AGAA_GEOMETRY_EVENTS_AT], agaa_groupEvents);
}
