// The lights that may reach what each tile of 8 by 8 pixels shows: a bit for each.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "math/light_culling.glsl"
#include "passes/sample_depth.glsl"
#include "passes/lights.glsl"
#include "passes/tile_pixels.glsl"

layout(std430, AGAA_AT_LIGHT_MASKS) writeonly buffer agaa_LightMaskBlock {
    uint words[];
} agaa_lightMasks;

// Around the samples of the tile in view space, and around those at the far plane, which may show geometry or nothing.
struct agaa_Box {
    vec3 low, high;
};
shared uint agaa_tileBoxes[12];
shared uint agaa_tileLights[AGAA_LIGHT_WORDS + 1u];

// Keeps the order of numbers.
uint agaa_orderedBits(float x) {
    uint bits = floatBitsToUint(x);
    return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}
float agaa_ofOrderedBits(uint bits) {
    return uintBitsToFloat((bits & 0x80000000u) != 0u ? bits & 0x7FFFFFFFu : ~bits);
}

agaa_Box agaa_emptyBox() { return agaa_Box(vec3(3.0e38), vec3(-3.0e38)); }

void agaa_addToTile(uint first, agaa_Box box) {
    if (box.low.x > box.high.x)
        return;
    for (uint axis = 0u; axis < 3u; ++axis) {
        atomicMin(agaa_tileBoxes[first + axis], agaa_orderedBits(box.low[axis]));
        atomicMax(agaa_tileBoxes[first + 3u + axis], agaa_orderedBits(box.high[axis]));
    }
}

agaa_Box agaa_boxOfTile(uint first) {
    agaa_Box box;
    for (uint axis = 0u; axis < 3u; ++axis) {
        box.low[axis] = agaa_ofOrderedBits(agaa_tileBoxes[first + axis]);
        box.high[axis] = agaa_ofOrderedBits(agaa_tileBoxes[first + 3u + axis]);
    }
    return box;
}

// False where the host's G-buffer shows no geometry.
bool agaa_readDepth(uvec2 pixel, uint i, out float depth) {
#ifdef AGAA_HOST_GBUFFER
    AgaaMaterial material;
    return agaa_readHost(pixel, i, depth, material);
#else
    depth = agaa_depthOf(pixel, i);
    return true;
#endif
}

void agaa_addPixel(uvec2 pixel) {
    agaa_Box near = agaa_emptyBox(), far = agaa_emptyBox();
    uint i = 0u;
    do {
        float depth;
        bool shows = agaa_readDepth(pixel, i, depth);
        bool isFar = depth == float(AGAA_FAR_DEPTH);
        vec3 at = agaa_sampleViewPosition(pixel, i, depth);
        near.low = shows && !isFar ? min(near.low, at) : near.low;
        near.high = shows && !isFar ? max(near.high, at) : near.high;
        far.low = shows && isFar ? min(far.low, at) : far.low;
        far.high = shows && isFar ? max(far.high, at) : far.high;
    } while (++i < agaa_sampleCount());
    agaa_addToTile(0u, near);
    agaa_addToTile(6u, far);
}

bool agaa_reaches(agaa_GpuLight light, agaa_Box box) {
    if (box.low.x > box.high.x)
        return false;
    uint type = floatBitsToUint(light.directionType.w);
    if (type == 0u)
        return true;
    vec3 at = mat3(agaa_frame.view) * light.positionRange.xyz;
    if (!agaa_rangeReaches(at, light.positionRange.w, box.low, box.high))
        return false;
    vec3 middle = 0.5 * (box.low + box.high);
    return type != 2u || agaa_coneReaches(at, mat3(agaa_frame.view) * light.directionType.xyz, light.cone.y, middle,
                                          length(box.high - middle));
}

void main() {
    const uint lane = gl_LocalInvocationIndex;
    for (uint i = lane; i < AGAA_LIGHT_WORDS; i += 64u)
        agaa_tileLights[i] = 0u;
    if (lane < 12u)
        agaa_tileBoxes[lane] = agaa_orderedBits(lane % 6u < 3u ? 3.0e38 : -3.0e38);
    barrier();
    uvec2 pixel = agaa_pixelOf(lane);
    if (all(lessThan(pixel, agaa_frame.size.xy)))
        agaa_addPixel(pixel);
    barrier();
    agaa_Box near = agaa_boxOfTile(0u), far = agaa_boxOfTile(6u);
    const uint count = agaa_lightBuffer.shadows[0].lightCount;
    for (uint i = lane; i < count; i += 64u) {
        agaa_GpuLight light = agaa_lightBuffer.lights[i];
        if (agaa_reaches(light, near) || agaa_reaches(light, far))
            atomicOr(agaa_tileLights[i >> 5u], 1u << (i & 31u));
    }
    barrier();
    const uint first = agaa_lightMaskAt(gl_WorkGroupID.xy);
    for (uint i = lane; i < AGAA_LIGHT_WORDS; i += 64u)
        agaa_lightMasks.words[first + i] = agaa_tileLights[i];
}
