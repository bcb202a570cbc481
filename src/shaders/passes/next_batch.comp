// Between two draws of the scene.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/fragment_layout.glsl"

layout(std430, AGAA_AT_FRAGMENTS) buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;

void main() {
    if (gl_LocalInvocationIndex != 0u)
        return;
    uint next = agaa_fragments.words[AGAA_LIST_BATCH] + 1u;
    agaa_fragments.words[AGAA_LIST_COUNT] = 0u;
    agaa_fragments.words[AGAA_LIST_BATCH] = next;
    agaa_fragments.words[AGAA_LIST_GOES_ON] = next < agaa_fragments.words[AGAA_LIST_BATCHES] ? 1u : 0u;
}
