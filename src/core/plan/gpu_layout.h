// Buffers shared with shaders, byte for byte, in the layouts std140 and std430.
#pragma once

#include "agaa_sdk.h"
#include "shaders/tables/layouts.inc"

#include <cstddef>
#include <cstdint>

namespace agaa {

#define AGAA_API_VALUE(name, value) static_assert(uint64_t(name) == value);
#include "shaders/tables/api_values.inc"
#undef AGAA_API_VALUE

// The types of GLSL.
using glsl_float = float;
using glsl_uint = uint32_t;
using glsl_vec2 = float[2];
using glsl_uvec2 = uint32_t[2];
using glsl_vec3 = float[3];
using glsl_vec4 = float[4];
using glsl_mat4 = float[16];

// src/shaders/tables/frame.inc. An element of an array in std140 has 16 bytes, so each vec4 of the table holds two
// vectors.
struct alignas(16) FrameConstants {
#define AGAA_FRAME_MEMBER(word, type, name) glsl_##type name;
#define AGAA_FRAME_BUFFER_MEMBER(word, type, name) glsl_##type name;
#define AGAA_FRAME_ARRAY(word, type, name, count) glsl_vec2 name[2 * (count)];
#include "shaders/tables/frame.inc"
};
#define AGAA_FRAME_MEMBER(word, type, name) static_assert(offsetof(FrameConstants, name) == 4 * (word));
#define AGAA_FRAME_BUFFER_MEMBER(word, type, name) static_assert(offsetof(FrameConstants, name) == 4 * (word));
#define AGAA_FRAME_ARRAY(word, type, name, count) static_assert(offsetof(FrameConstants, name) == 4 * (word));
#include "shaders/tables/frame.inc"

struct GpuShadow {
    float matrices[AGAA_MAX_SHADOW_LAYERS][16];
    float bias;
    uint32_t layerCount;
    uint32_t lightCount; // of the frame, in the first
    uint32_t padding;
};

struct GpuLight {
    float position[3];
    float range;
    float direction[3];
    uint32_t type;
    float color[3];
    uint32_t shadowMap;
    float cosInner, cosOuter;
    float radius;
    float padding;
};
static_assert(sizeof(GpuLight) == 64);

inline uint64_t lightBufferBytes(uint32_t maxLights) {
    return AGAA_MAX_SHADOW_MAPS * sizeof(GpuShadow) + uint64_t(maxLights ? maxLights : 1) * sizeof(GpuLight);
}

enum Counter : uint32_t {
#define AGAA_COUNTER(index, name, member) name = index,
#define AGAA_COUNTER_MAX(index, name, member) name = index, counterCount
#define AGAA_COUNTER_FACT(index, name, member, fact) name = index,
#include "shaders/tables/counters.inc"
#undef AGAA_COUNTER
#undef AGAA_COUNTER_MAX
#undef AGAA_COUNTER_FACT
};

struct CounterBuffer {
    uint32_t counts[counterCount][2];                                   // by Counter; low word first
    uint32_t invalidPixels;                                             // found; the first of them follow
    uint32_t stamp;                                                     // stampOf() the frame; padding in shaders
    uint32_t pixels[AGAA_MAX_INVALID_PIXELS][AGAA_INVALID_PIXEL_WORDS]; // AgaaInvalidPixel without its end
};
static_assert(sizeof(CounterBuffer) == 4 * (2 * counterCount + 2 + AGAA_INVALID_PIXEL_WORDS * AGAA_MAX_INVALID_PIXELS));
static_assert(offsetof(AgaaInvalidPixel, reserved) == sizeof(CounterBuffer::pixels[0]));

// A pass that the device reached.
struct Breadcrumb {
    uint64_t frame; // AgaaFrame::frameIndex; 0: no pass
    uint32_t pass;
    uint32_t repetition;
};
struct BreadcrumbBuffer {
    Breadcrumb begun, ended;
};

// Returns the word that marks the statistics of a frame; never 0.
constexpr uint32_t stampOf(uint64_t frameIndex) { return uint32_t(frameIndex % ~0u) + 1; }

} // namespace agaa
