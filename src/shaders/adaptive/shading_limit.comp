// Finds the limit of demand above which the further samples of shading are shaded, so that all events do not exceed the
// target.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "adaptive/limit_bin.glsl"

void main() {
    if (gl_LocalInvocationIndex != 0u)
        return;
    float room = uintBitsToFloat(AGAA_TARGET_EVENTS) * float(agaa_choices.words[AGAA_COVERED_PIXELS_AT]) -
                 float(agaa_choices.words[AGAA_GEOMETRY_EVENTS_AT]);
    agaa_choices.words[AGAA_DEMAND_LIMIT_AT] = agaa_limitBin(AGAA_DEMAND_AT, room);
}
