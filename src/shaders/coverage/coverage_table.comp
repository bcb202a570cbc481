// Fills the table of half-planes for the host's pattern of coverage samples (DCAA section 3.1, figure 3).
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "math/coverage_table.glsl"

layout(rgba32ui, AGAA_BINDING_COVERAGE_TABLE_OUT) writeonly uniform uimage2D agaa_table;

void main() {
    const uint entry = gl_GlobalInvocationID.x; // one row of workgroups suffices for the largest table
    if (entry >= AGAA_TABLE_SIZE * AGAA_TABLE_SIZE)
        return;
    uvec4 mask = uvec4(0u);
    for (uint i = 0u; i < AGAA_SAMPLES; ++i)
        mask[i >> 5u] |= agaa_isInTableEntry(entry, AGAA_TABLE_SIZE, agaa_hostPosition(i)) ? 1u << (i & 31u) : 0u;
    imageStore(agaa_table, ivec2(agaa_tableTexel(entry, AGAA_TABLE_SIZE)), mask);
}
