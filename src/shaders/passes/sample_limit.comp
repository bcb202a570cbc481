// The least difference at which the samples that differ by more are no more than the target allows.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/adaptive_flags.glsl"
#include "passes/limit_bin.glsl"

// Of the further samples, what is for geometry where shading may call for more.
const float agaa_geometryShare = 0.75;

void main() {
    if (gl_LocalInvocationIndex != 0u)
        return;
    float share = agaa_isAdaptive(agaa_byShading) ? agaa_geometryShare : 1.0;
    uint bin = agaa_limitBin(0u, max(uintBitsToFloat(AGAA_TARGET_EVENTS) - 1.0, 0.0) * share *
                                     float(agaa_choices.words[agaa_coveredPixels]));
    // Beyond the last bin: nothing differs as much.
    float limit = bin == agaa_bins() ? 3.0e38 : agaa_differenceOfBin(bin);
    agaa_choices.words[agaa_limitBits] = floatBitsToUint(limit);
}
