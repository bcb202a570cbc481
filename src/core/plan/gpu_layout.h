// Buffers shared with shaders, byte for byte (src/shaders/common/frame.glsl, std140 and std430).
#pragma once

#include "agaa_sdk.h"

#include <cstddef>
#include <cstdint>

namespace agaa {

struct FrameConstants {
    float view[16];        // shading to view space, a rotation
    float projection[8];   // p00, p11, offset x, y (p20, p21; orthographic p30, p31);
                           // p22, p32, orthographic, depth quantum
    uint32_t size[4];      // width, height, effects that the frame leaves out (AGAA_FACT_…), background comes from the output
    float cluster[4];      // k, k per distance, t, 0
    float ambient[4];      // rgb, emissive range
    float background[4];
    float surface[4];      // one surface: least cosine, distance in pixels, difference of materials; n
    uint32_t ditherFrame;  // AgaaFrame::ditherFrame
    uint32_t feedback[3];  // counters of the newest finished frame, by Plan::feedback
    float samples[128][2]; // xy in the pixel, [0;1]
    uint32_t counts[4];    // c; fragments that lists have room for; draws of the scene at most; 0
};
static_assert(sizeof(FrameConstants) == 64 + 32 + 16 * 7 + 1024);

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
    uint32_t counts[counterCount][2]; // by Counter; low word first
    uint32_t invalidPixels;           // found; the first of them follow
    uint32_t padding;
    uint32_t pixels[AGAA_MAX_INVALID_PIXELS][14]; // AgaaInvalidPixel without its end
};
static_assert(sizeof(CounterBuffer) == 4 * (2 * counterCount + 2 + 14 * AGAA_MAX_INVALID_PIXELS));
static_assert(offsetof(AgaaInvalidPixel, reserved) == sizeof(CounterBuffer::pixels[0]));

} // namespace agaa
