// Prepares the next draw of the scene, or ends the repetition.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "coverage/fragment_layout.glsl"

layout(std430, AGAA_BINDING_FRAGMENTS) buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;

void main() {
    if (gl_LocalInvocationIndex != 0u)
        return;
    uint next = agaa_fragments.words[AGAA_LIST_BATCH] + 1u;
    agaa_fragments.words[AGAA_LIST_COUNT] = 0u;
    agaa_fragments.words[AGAA_LIST_BATCH] = next;
    bool isFinished = next >= agaa_fragments.words[AGAA_LIST_BATCHES];
    agaa_fragments.words[AGAA_LIST_FINISHED] = isFinished ? 1u : 0u;
    for (uint i = 0u; i < 3u && isFinished; ++i) {
        agaa_fragments.words[AGAA_LIST_TILE_GROUPS + i] = 0u;
        agaa_fragments.words[AGAA_LIST_TRIANGLE_GROUPS + i] = 0u;
    }
}
