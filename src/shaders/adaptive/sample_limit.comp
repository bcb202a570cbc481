// Finds the limit of differences such that the samples above it do not exceed the target.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "adaptive/adaptive_flags.glsl"
#include "adaptive/limit_bin.glsl"

// The share of the further samples that geometry gets if shading may demand more.
const float agaa_geometryShare = 0.75;

void main() {
    if (gl_LocalInvocationIndex != 0u)
        return;
    float share = agaa_isAdaptive(AGAA_ADAPTIVE_SHADING) ? agaa_geometryShare : 1.0;
    float room =
        max(uintBitsToFloat(AGAA_TARGET_EVENTS) - 1.0, 0.0) * share * float(agaa_choices.words[AGAA_COVERED_PIXELS_AT]);
    agaa_choices.words[AGAA_DIFFERENCE_LIMIT_AT] = agaa_limitBin(AGAA_DIFFERENCES_AT, room);
}
