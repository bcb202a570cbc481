// Constants of a frame; the layout is FrameConstants of core/gpu_layout.h.
#ifndef AGAA_FRAME_GLSL
#define AGAA_FRAME_GLSL
layout(std140, AGAA_AT_FRAME) uniform agaa_FrameBlock {
    mat4 view;        // shading to view space, a rotation
    vec4 projection0; // p00, p11, offset x, y: p20, p21; orthographic p30, p31
    vec4 projection1; // p22, p32, orthographic, depth quantum
    uvec4 size;       // width, height, light count, background comes from the output
    vec4 cluster;     // k, k per distance, t, 0
    vec4 ambient;     // rgb, emissive range
    vec4 background;
    vec4 surface;     // one surface: least cosine, distance in pixels, difference of materials; n
    uvec4 dither;     // AgaaFrame::ditherFrame, then counters of the newest finished frame (Plan::feedback)
    vec4 sampleLocations[64]; // of two samples each: xy, zw in the pixel
} agaa_frame;

vec2 agaa_sampleLocation(uint i) {
    vec4 two = agaa_frame.sampleLocations[i >> 1u];
    return (i & 1u) != 0u ? two.zw : two.xy;
}

// n, as a value that compilers do not know: with a constant they unroll loops within loops.
uint agaa_sampleCount() { return uint(agaa_frame.surface.w); }
#endif
