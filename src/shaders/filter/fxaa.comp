// FXAA (Lottes 2009, the quality variant). If luma has contrast, the pass follows the edge through a pixel to its ends
// and mixes in the neighbour across the edge by the edge's slope. Luma and mixing are those of the tone-mapped image.
// The output stays linear.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/output_place.glsl"
#include "math/display.glsl"

layout(AGAA_BINDING_COLOR) uniform sampler2D agaa_shaded; // a: luma
layout(AGAA_BINDING_OUTPUT) writeonly uniform image2D agaa_output;

const float agaa_contrast = 0.125;      // lowest contrast, as a share of the brightest neighbour
const float agaa_darkContrast = 0.0312; // lowest visible contrast
const float agaa_subpixelShare = 0.75;  // strength of the filter that removes single bright pixels
// Distances in pixels at which the edge is tested in each direction. Longer ones skip pixels.
const int agaa_edgeSteps[10] = int[](1, 2, 3, 4, 5, 7, 9, 12, 16, 24);

vec4 agaa_texel(ivec2 at) { return texelFetch(agaa_shaded, clamp(at, ivec2(0), ivec2(agaa_frame.size) - 1), 0); }

vec3 agaa_color(ivec2 at) { return max(agaa_texel(at).rgb, vec3(0.0)); }

float agaa_luma(ivec2 at) { return agaa_texel(at).a; }

struct agaa_Edge {
    ivec2 across; // to the neighbour on the other side
    ivec2 along;
    float luma;   // mean of the two sides
    float step;   // difference of luma at the edge's end
};

struct agaa_Neighbours {
    float m, n, s, w, e, nw, ne, sw, se;
};

float agaa_secondDifference(float a, float b, float c) { return abs(a + c - 2.0 * b); }

agaa_Edge agaa_findEdge(agaa_Neighbours l) {
    float horizontal = agaa_secondDifference(l.nw, l.w, l.sw) + 2.0 * agaa_secondDifference(l.n, l.m, l.s) +
                       agaa_secondDifference(l.ne, l.e, l.se);
    float vertical = agaa_secondDifference(l.nw, l.n, l.ne) + 2.0 * agaa_secondDifference(l.w, l.m, l.e) +
                     agaa_secondDifference(l.sw, l.s, l.se);
    bool isHorizontal = horizontal >= vertical;
    float before = isHorizontal ? l.n : l.w;
    float after = isHorizontal ? l.s : l.e;
    bool toBefore = abs(before - l.m) >= abs(after - l.m);
    agaa_Edge edge;
    edge.across = (isHorizontal ? ivec2(0, 1) : ivec2(1, 0)) * (toBefore ? -1 : 1);
    edge.along = isHorizontal ? ivec2(1, 0) : ivec2(0, 1);
    float other = toBefore ? before : after;
    edge.luma = 0.5 * (l.m + other);
    edge.step = 0.25 * abs(other - l.m);
    return edge;
}

// Returns the distance to the edge's end in one direction. departure receives the difference from the edge's luma
// there.
float agaa_followEdge(ivec2 pixel, agaa_Edge edge, int direction, out float departure) {
    departure = 0.0;
    int reached = 0;
    for (int i = 0; i < 10; ++i) {
        reached = agaa_edgeSteps[i];
        ivec2 at = pixel + edge.along * (direction * reached);
        departure = 0.5 * (agaa_luma(at) + agaa_luma(at + edge.across)) - edge.luma;
        if (abs(departure) >= edge.step)
            break;
    }
    return float(reached);
}

// Returns the distance, [0, 1/2], by which the pixel moves toward the neighbour across so that the edge is straight.
float agaa_edgeShift(ivec2 pixel, agaa_Edge edge, float luma) {
    float departures[2];
    float one = agaa_followEdge(pixel, edge, -1, departures[0]);
    float two = agaa_followEdge(pixel, edge, 1, departures[1]);
    float departure = one < two ? departures[0] : departures[1];
    // The pixel moves only if the edge bends to the pixel's side at the nearer end.
    bool bends = (departure < 0.0) != (luma < edge.luma);
    return bends ? 0.5 - min(one, two) / (one + two) : 0.0;
}

float agaa_subpixelShift(agaa_Neighbours l, float range) {
    float mean = (2.0 * (l.n + l.s + l.w + l.e) + l.nw + l.ne + l.sw + l.se) / 12.0;
    float share = smoothstep(0.0, 1.0, clamp(abs(mean - l.m) / range, 0.0, 1.0));
    return agaa_subpixelShare * share * share;
}

vec3 agaa_filtered(ivec2 pixel) {
    vec3 color = agaa_color(pixel);
    agaa_Neighbours l;
    l.m = agaa_luma(pixel);
    l.n = agaa_luma(pixel + ivec2(0, -1));
    l.s = agaa_luma(pixel + ivec2(0, 1));
    l.w = agaa_luma(pixel + ivec2(-1, 0));
    l.e = agaa_luma(pixel + ivec2(1, 0));
    float brightest = max(l.m, max(max(l.n, l.s), max(l.w, l.e)));
    float range = brightest - min(l.m, min(min(l.n, l.s), min(l.w, l.e)));
    if (range < max(agaa_darkContrast, brightest * agaa_contrast))
        return color;
    l.nw = agaa_luma(pixel + ivec2(-1, -1));
    l.ne = agaa_luma(pixel + ivec2(1, -1));
    l.sw = agaa_luma(pixel + ivec2(-1, 1));
    l.se = agaa_luma(pixel + ivec2(1, 1));
    agaa_Edge edge = agaa_findEdge(l);
    float shift = max(agaa_edgeShift(pixel, edge, l.m), agaa_subpixelShift(l, range));
    if (shift <= 0.0)
        return color;
    vec3 other = agaa_color(pixel + edge.across);
    return vec3(agaa_mixDisplayed(color.x, other.x, shift), agaa_mixDisplayed(color.y, other.y, shift),
                agaa_mixDisplayed(color.z, other.z, shift));
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (all(lessThan(pixel, agaa_frame.size)))
        imageStore(agaa_output, agaa_placeInWritten(ivec2(pixel)),
                   vec4(min(agaa_filtered(ivec2(pixel)), vec3(AGAA_MAX_HALF)), 1.0));
}
