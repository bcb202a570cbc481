// SMAA, first pass: finds edges where neighbouring pixels differ in a displayed colour channel, unless a stronger edge
// is beside (local contrast adaptation). Jimenez et al. 2012, section 4.1.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "math/display.glsl"
#define AGAA_EDGES_ACCESS writeonly
#define AGAA_READS_EDGES 0
#include "filter/edge_words.glsl"

layout(AGAA_BINDING_COLOR) uniform sampler2D agaa_shaded;

const float agaa_edgeContrast = 0.05;
const float agaa_adaptation = 2.0; // an edge is hidden by one beside it with more than this times its contrast

// The region's pixels, two more before it and one after it, in eight bits per displayed channel.
const int agaa_before = 2;
const int agaa_side = 32 + agaa_before + 1;
shared uint agaa_colors[agaa_side * agaa_side];

void agaa_loadColors(ivec2 corner) {
    ivec2 last = ivec2(agaa_frame.size) - 1;
    for (uint i = gl_LocalInvocationIndex; i < uint(agaa_side * agaa_side); i += 64u) {
        ivec2 at = clamp(corner + ivec2(i % uint(agaa_side), i / uint(agaa_side)), ivec2(0), last);
        agaa_colors[i] = packUnorm4x8(vec4(agaa_displayed(texelFetch(agaa_shaded, at, 0).rgb), 0.0));
    }
}

// pixel   In the region; from -2 to 32.
vec3 agaa_colorAt(ivec2 pixel) {
    ivec2 at = pixel + agaa_before;
    return unpackUnorm4x8(agaa_colors[at.y * agaa_side + at.x]).rgb;
}

// Returns whether the pixel has an upper and a left edge.
bvec2 agaa_edgesOf(ivec2 pixel) {
    vec3 color = agaa_colorAt(pixel);
    vec3 above = agaa_colorAt(pixel - ivec2(0, 1));
    vec3 left = agaa_colorAt(pixel - ivec2(1, 0));
    vec2 contrast = vec2(agaa_colorDifference(color, above), agaa_colorDifference(color, left));
    float strongest = max(contrast.x, contrast.y);
    strongest = max(strongest, agaa_colorDifference(color, agaa_colorAt(pixel + ivec2(0, 1))));
    strongest = max(strongest, agaa_colorDifference(color, agaa_colorAt(pixel + ivec2(1, 0))));
    strongest = max(strongest, agaa_colorDifference(above, agaa_colorAt(pixel - ivec2(0, 2))));
    strongest = max(strongest, agaa_colorDifference(left, agaa_colorAt(pixel - ivec2(2, 0))));
    return greaterThanEqual(contrast, vec2(max(agaa_edgeContrast, strongest / agaa_adaptation)));
}

void main() {
    ivec2 corner = ivec2(gl_WorkGroupID.xy) * 32;
    agaa_loadColors(corner - agaa_before);
    barrier();
    // Half of the lanes have a row each, half a column.
    uint direction = gl_LocalInvocationIndex / 32u;
    uint line = gl_LocalInvocationIndex % 32u;
    ivec2 rest = ivec2(agaa_frame.size) - corner;
    uint along = 0u, crossing = 0u;
    for (uint i = 0u; i < 32u; ++i) {
        ivec2 pixel = direction == agaa_rows ? ivec2(i, line) : ivec2(line, i);
        bvec2 edges = agaa_edgesOf(pixel);
        if (any(greaterThanEqual(pixel, rest)))
            edges = bvec2(false);
        along |= (direction == agaa_rows ? edges.x : edges.y) ? 1u << i : 0u;
        crossing |= (direction == agaa_rows ? edges.y : edges.x) ? 1u << i : 0u;
    }
    agaa_edges.words[agaa_edgeWordAt(gl_WorkGroupID.xy, direction, 0u, line)] = along;
    agaa_edges.words[agaa_edgeWordAt(gl_WorkGroupID.xy, direction, 1u, line)] = crossing;
}
