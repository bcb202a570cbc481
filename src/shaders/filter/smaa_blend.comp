// SMAA, third pass: mixes each pixel with its neighbours across edges by the shares beyond them, in the direction of
// the largest share. Jimenez et al. 2012, section 4.2.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/output_place.glsl"
#include "math/display.glsl"

layout(AGAA_BINDING_COLOR) uniform sampler2D agaa_shaded;
layout(AGAA_BINDING_OUTPUT) writeonly uniform image2D agaa_output;
layout(std430, AGAA_BINDING_SHARES) readonly buffer agaa_ShareBlock { uint words[]; } agaa_shares;

vec3 agaa_color(ivec2 at) {
    return max(texelFetch(agaa_shaded, clamp(at, ivec2(0), ivec2(agaa_frame.size) - 1), 0).rgb, vec3(0.0));
}

vec4 agaa_sharesAt(uvec2 pixel) {
    if (any(greaterThanEqual(pixel, agaa_frame.size)))
        return vec4(0.0);
    return unpackUnorm4x8(agaa_shares.words[pixel.y * agaa_frame.size.x + pixel.x]);
}

vec3 agaa_mixColors(vec3 a, vec3 b, float share) {
    return vec3(agaa_mixDisplayed(a.x, b.x, share), agaa_mixDisplayed(a.y, b.y, share),
                agaa_mixDisplayed(a.z, b.z, share));
}

vec3 agaa_blended(uvec2 pixel) {
    ivec2 at = ivec2(pixel);
    vec3 color = agaa_color(at);
    vec4 own = agaa_sharesAt(pixel);
    vec2 vertical = vec2(own.x, agaa_sharesAt(pixel + uvec2(0u, 1u)).y);
    vec2 horizontal = vec2(own.z, agaa_sharesAt(pixel + uvec2(1u, 0u)).w);
    float largest = max(max(vertical.x, vertical.y), max(horizontal.x, horizontal.y));
    if (largest <= 0.0)
        return color;
    bool isVertical = max(vertical.x, vertical.y) >= max(horizontal.x, horizontal.y);
    vec2 shares = isVertical ? vertical : horizontal;
    ivec2 step = isVertical ? ivec2(0, 1) : ivec2(1, 0);
    // Each side has its weight in the mean of both.
    vec2 weights = shares / (shares.x + shares.y);
    return agaa_mixColors(agaa_mixColors(color, agaa_color(at - step), shares.x),
                          agaa_mixColors(color, agaa_color(at + step), shares.y), weights.y);
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (all(lessThan(pixel, agaa_frame.size)))
        imageStore(agaa_output, agaa_placeInWritten(ivec2(pixel)),
                   vec4(min(agaa_blended(pixel), vec3(AGAA_MAX_HALF)), 1.0));
}
