// Constants of a frame; the layout is FrameConstants of core/plan/gpu_layout.h.
#ifndef AGAA_FRAME_GLSL
#define AGAA_FRAME_GLSL
#include "common/fact_bits.glsl"
#ifndef AGAA_FRAME_CONSTANTS
#define AGAA_FRAME_CONSTANTS 0 // AgaaGlConstants
// Of compute passes, whose groups have no depth: the value, which compilers then do not know. Where members of a uniform block
// decide branches and loops, Mesa 22.3's lavapipe puts their values into the shader, and compiles it anew in each frame.
uint agaa_opaque(uint value) { return value + (gl_NumWorkGroups.z - 1u); }
#define AGAA_FRAMES_LEAVE_OUT 1
#else
#define AGAA_FRAMES_LEAVE_OUT 0 // hosts' shaders are those of the view's facts
uint agaa_opaque(uint value) { return value; }
#endif
#if AGAA_FRAME_CONSTANTS == 0
layout(std140, AGAA_BINDING_FRAME) uniform agaa_FrameBlock {
    mat4 view;        // shading to view space, a rotation
    vec4 projection0; // p00, p11, offset x, y: p20, p21; orthographic p30, p31
    vec4 projection1; // p22, p32, orthographic, depth quantum
    uvec4 size;       // width, height, effects that the frame leaves out, background comes from the output
    vec4 cluster;     // k, k per distance, t, 0
    vec4 ambient;     // rgb, emissive range
    vec4 background;
    vec4 surface;     // one surface: least cosine, distance in pixels, difference of materials; n
    uvec4 dither;     // AgaaFrame::ditherFrame, then counters of the newest finished frame (Plan::feedback)
    vec4 sampleLocations[64]; // of two samples each: xy, zw in the pixel
    uvec4 counts; // c; fragments that lists have room for; draws of the scene at most; 0
} agaa_frame;

vec4 agaa_sampleLocations(uint i) { return agaa_frame.sampleLocations[i]; }
uint agaa_fragmentRoom() { return agaa_frame.counts.y; }
#else
// The same for hosts without uniform blocks: 12 vectors, then sample locations.
struct agaa_FrameConstants {
    mat4 view;
    vec4 projection0, projection1;
    uvec4 size;
    vec4 cluster, ambient, background, surface;
    uvec4 dither;
};
#if AGAA_FRAME_CONSTANTS == 1
uniform vec4 agaa_constants[AGAA_CONSTANT_VECTORS]; // core/frame/frame_data.h, uniformConstants()
vec4 agaa_constant(uint i) { return agaa_constants[i]; }
uvec4 agaa_constantWords(uint i) { return uvec4(agaa_constants[i]); }
uvec4 agaa_constantDither() {
    uvec4 halves = agaa_constantWords(11u);
    return uvec4(halves.x | halves.y << 16u, 0u, 0u, 0u);
}
uint agaa_fragmentRoom() {
    uvec4 halves = agaa_constantWords(11u);
    return halves.z | halves.w << 16u;
}
#else
layout(AGAA_BINDING_FRAME) uniform usamplerBuffer agaa_constantTexels;
uvec4 agaa_constantWords(uint i) { return texelFetch(agaa_constantTexels, int(i)); }
vec4 agaa_constant(uint i) { return uintBitsToFloat(agaa_constantWords(i)); }
uvec4 agaa_constantDither() { return agaa_constantWords(11u); }
uint agaa_fragmentRoom() { return agaa_constantWords(76u).y; }
#endif

agaa_FrameConstants agaa_loadFrame() {
    return agaa_FrameConstants(mat4(agaa_constant(0u), agaa_constant(1u), agaa_constant(2u), agaa_constant(3u)),
                               agaa_constant(4u), agaa_constant(5u), agaa_constantWords(6u), agaa_constant(7u),
                               agaa_constant(8u), agaa_constant(9u), agaa_constant(10u), agaa_constantDither());
}
#define agaa_frame agaa_loadFrame()

vec4 agaa_sampleLocations(uint i) { return agaa_constant(12u + i); }
#endif

vec2 agaa_sampleLocation(uint i) {
    vec4 two = agaa_sampleLocations(i >> 1u);
    return (i & 1u) != 0u ? two.zw : two.xy;
}

// Whether the frame is shown without an effect that the pipeline has: the variant without it may not be prepared.
bool agaa_leavesOut(uint fact) {
#if AGAA_FRAMES_LEAVE_OUT
    return (agaa_opaque(agaa_frame.size.z) & fact) != 0u;
#else
    return false;
#endif
}

// n, as a value that compilers do not know: with a constant they unroll loops within loops.
uint agaa_sampleCount() { return agaa_opaque(uint(agaa_frame.surface.w)); }
#if AGAA_FRAME_CONSTANTS == 0
// c, likewise.
uint agaa_aggregateLimit() { return agaa_opaque(agaa_frame.counts.x); }
#endif
#endif
