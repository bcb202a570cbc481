// Constants of a frame (tables/frame.inc), in a uniform block or, for hosts without uniform blocks, in uniforms or
// texels. Needs AGAA_BINDING_FRAME. With AGAA_GL_CONSTANTS_UNIFORMS it needs AGAA_CONSTANT_VECTORS instead.
#ifndef AGAA_FRAME_GLSL
#define AGAA_FRAME_GLSL
#include "common/api_values.glsl"
// Values of AGAA_FRAME_CONSTANTS, those of AgaaGlConstants.
#define AGAA_CONSTANTS_BLOCK 0
#define AGAA_CONSTANTS_UNIFORMS 1
#define AGAA_CONSTANTS_TEXELS 2
#ifndef AGAA_FRAME_CONSTANTS
#define AGAA_FRAME_CONSTANTS AGAA_CONSTANTS_BLOCK
// Returns the value such that compilers do not know it. For compute passes, whose groups have no depth. Where members
// of a uniform block decide branches and loops, Mesa 22.3's lavapipe puts their values into the shader and compiles it
// again in each frame.
uint agaa_opaque(uint value) { return value + (gl_NumWorkGroups.z - 1u); }
#define AGAA_FRAMES_LEAVE_OUT 1
#else
#define AGAA_FRAMES_LEAVE_OUT 0 // the host's shaders have the facts of the view
uint agaa_opaque(uint value) { return value; }
#endif
#if AGAA_FRAME_CONSTANTS == AGAA_CONSTANTS_UNIFORMS
#ifndef AGAA_CONSTANT_VECTORS
#error "frame.glsl needs AGAA_CONSTANT_VECTORS."
#endif
#elif !defined(AGAA_BINDING_FRAME)
#error "frame.glsl needs AGAA_BINDING_FRAME."
#endif

#if AGAA_FRAME_CONSTANTS == AGAA_CONSTANTS_BLOCK
layout(std140, AGAA_BINDING_FRAME) uniform agaa_FrameBlock {
#define AGAA_FRAME_MEMBER(word, type, name) type name;
#define AGAA_FRAME_BUFFER_MEMBER(word, type, name) type name;
#define AGAA_FRAME_ARRAY(word, type, name, count) type name[count];
#include "tables/frame.inc"
} agaa_frame;

vec4 agaa_sampleLocations(uint i) { return agaa_frame.sampleLocations[i]; }
#else
struct agaa_FrameConstants {
#define AGAA_FRAME_MEMBER(word, type, name) type name;
#if AGAA_FRAME_CONSTANTS == AGAA_CONSTANTS_TEXELS
#define AGAA_FRAME_BUFFER_MEMBER(word, type, name) type name;
#else
#define AGAA_FRAME_UNIFORM_MEMBER(word, type, name) type name;
#endif
#include "tables/frame.inc"
};

#if AGAA_FRAME_CONSTANTS == AGAA_CONSTANTS_UNIFORMS
uniform vec4 agaa_constants[AGAA_CONSTANT_VECTORS]; // core/frame/frame_data.h, uniformConstants()
vec4 agaa_constant(uint i) { return agaa_constants[i]; }
uvec4 agaa_constantWords(uint i) { return uvec4(agaa_constants[i]); }
#else
layout(AGAA_BINDING_FRAME) uniform usamplerBuffer agaa_constantTexels;
uvec4 agaa_constantWords(uint i) { return texelFetch(agaa_constantTexels, int(i)); }
vec4 agaa_constant(uint i) { return uintBitsToFloat(agaa_constantWords(i)); }
#endif

void agaa_loadConstant(uint word, out float v) { v = agaa_constant(word / 4u)[word % 4u]; }
void agaa_loadConstant(uint word, out uint v) { v = agaa_constantWords(word / 4u)[word % 4u]; }
void agaa_loadConstant(uint word, out vec2 v) {
    v = word % 4u == 0u ? agaa_constant(word / 4u).xy : agaa_constant(word / 4u).zw;
}
void agaa_loadConstant(uint word, out uvec2 v) { v = agaa_constantWords(word / 4u).xy; }
void agaa_loadConstant(uint word, out vec3 v) { v = agaa_constant(word / 4u).xyz; }
void agaa_loadConstant(uint word, out vec4 v) { v = agaa_constant(word / 4u); }
void agaa_loadConstant(uint word, out mat4 v) {
    uint i = word / 4u;
    v = mat4(agaa_constant(i), agaa_constant(i + 1u), agaa_constant(i + 2u), agaa_constant(i + 3u));
}

agaa_FrameConstants agaa_loadFrame() {
    agaa_FrameConstants frame;
#define AGAA_FRAME_MEMBER(word, type, name) agaa_loadConstant(uint(word), frame.name);
#if AGAA_FRAME_CONSTANTS == AGAA_CONSTANTS_TEXELS
#define AGAA_FRAME_BUFFER_MEMBER(word, type, name) agaa_loadConstant(uint(word), frame.name);
#else
#define AGAA_FRAME_UNIFORM_MEMBER(word, type, name) agaa_loadConstant(uint(word), frame.name);
#endif
#include "tables/frame.inc"
#if AGAA_FRAME_CONSTANTS == AGAA_CONSTANTS_UNIFORMS
    frame.ditherFrame |= frame.ditherFrameHigh << 16u;
#endif
    return frame;
}
#define agaa_frame agaa_loadFrame()

#define AGAA_FRAME_ARRAY(word, type, name, count) \
    type agaa_sampleLocations(uint i) { return agaa_constant(uint(word) / 4u + i); }
#include "tables/frame.inc"
#endif

// Returns the number of fragments that the lists have room for.
uint agaa_fragmentCapacity() {
#if AGAA_FRAME_CONSTANTS == AGAA_CONSTANTS_UNIFORMS
    return agaa_frame.fragmentCapacityLow | agaa_frame.fragmentCapacityHigh << 16u;
#else
    return agaa_frame.fragmentCapacity;
#endif
}

vec2 agaa_sampleLocation(uint i) {
    vec4 two = agaa_sampleLocations(i >> 1u);
    return (i & 1u) != 0u ? two.zw : two.xy;
}

// Returns the point of the pixel that the centre of a layer's texel shows. firstLayer: that of the first layer.
// first   The layer's first sample.
vec2 agaa_layerCentre(vec2 firstLayer, uint first) {
    return firstLayer + (agaa_sampleLocation(first) - agaa_sampleLocation(0u));
}

// Returns whether the frame does not show an effect that the pipeline has: the variant without it may not be compiled
// yet.
bool agaa_leavesOut(uint fact) {
#if AGAA_FRAMES_LEAVE_OUT
    return (agaa_opaque(agaa_frame.absentEffects) & fact) != 0u;
#else
    return false;
#endif
}

// n, as a value that compilers do not know: with a constant they unroll loops within loops.
uint agaa_sampleCount() { return agaa_opaque(agaa_frame.sampleCount); }
#if AGAA_FRAME_CONSTANTS == AGAA_CONSTANTS_BLOCK
// c, likewise.
uint agaa_aggregateLimit() { return agaa_opaque(agaa_frame.aggregates); }
#endif
#endif
