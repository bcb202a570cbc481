// Light culling: writes bit masks of the lights that may reach the geometry of each tile of 8 by 8 pixels, and of the
// shadows of these lights.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_COUNTING 0
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "math/light_culling.glsl"
#include "common/sample_depth.glsl"
#include "common/lights.glsl"
#include "tables/lighting.inc"
#include "common/tile_pixels.glsl"
#include "math/ordered_bits.glsl"

layout(std430, AGAA_BINDING_LIGHT_MASKS) writeonly buffer agaa_LightMaskBlock {
    uint words[];
} agaa_lightMasks;

// Bounding box in view space.
struct agaa_Box {
    vec3 low, high;
};
shared uint agaa_tileBox[6];
shared uint agaa_tileLights[AGAA_LIGHT_WORDS + 1u]; // the last word is the mask of shadows

agaa_Box agaa_emptyBox() { return agaa_Box(vec3(3.0e38), vec3(-3.0e38)); }

void agaa_addToTile(agaa_Box box) {
    if (box.low.x > box.high.x)
        return;
    for (uint axis = 0u; axis < 3u; ++axis) {
        atomicMin(agaa_tileBox[axis], agaa_orderedBits(box.low[axis]));
        atomicMax(agaa_tileBox[3u + axis], agaa_orderedBits(box.high[axis]));
    }
}

agaa_Box agaa_boxOfTile() {
    agaa_Box box;
    for (uint axis = 0u; axis < 3u; ++axis) {
        box.low[axis] = agaa_fromOrderedBits(agaa_tileBox[axis]);
        box.high[axis] = agaa_fromOrderedBits(agaa_tileBox[3u + axis]);
    }
    return box;
}

// Returns false where the sample has no geometry. In targets of the SDK that is the far plane (host/far_plane.glsl).
bool agaa_readDepth(uvec2 pixel, uint i, out float depth) {
#ifdef AGAA_HOST_GBUFFER
    AgaaMaterial material;
    return agaa_readHost(pixel, i, depth, material);
#else
    depth = agaa_depthOf(pixel, i);
    return depth != float(AGAA_FAR_DEPTH);
#endif
}

void agaa_addPixel(uvec2 pixel) {
    agaa_Box box = agaa_emptyBox();
    uint i = 0u;
    do {
        float depth;
        bool shows = agaa_readDepth(pixel, i, depth);
        vec3 at = agaa_sampleViewPosition(pixel, i, depth);
        box.low = shows ? min(box.low, at) : box.low;
        box.high = shows ? max(box.high, at) : box.high;
    } while (++i < agaa_sampleCount());
    agaa_addToTile(box);
}

// toView   The inverse of agaa_toShadingSpace(). Views of hosts are rotations up to rounding only.
bool agaa_reaches(agaa_GpuLight light, agaa_Box box, mat3 toView) {
    if (light.type == AGAA_LIGHT_DIRECTIONAL)
        return true;
    vec3 at = toView * light.position;
    if (!agaa_rangeReaches(at, light.range, box.low, box.high))
        return false;
    vec3 middle = 0.5 * (box.low + box.high);
    vec3 direction = toView * light.direction;
    float size = max(length(direction), 0.5); // about 1
    return light.type != AGAA_LIGHT_SPOT ||
           agaa_coneReaches(at, direction / size, light.cosOuter / size, middle, length(box.high - middle));
}

void main() {
    const uint lane = gl_LocalInvocationIndex;
    for (uint i = lane; i <= AGAA_LIGHT_WORDS; i += 64u)
        agaa_tileLights[i] = 0u;
    if (lane < 6u)
        agaa_tileBox[lane] = agaa_orderedBits(lane < 3u ? 3.0e38 : -3.0e38);
    barrier();
    const uint count = agaa_lightBuffer.shadows[0].lightCount;
    const bool areFew = count < AGAA_LEAST_CULLED_LIGHTS;
    uvec2 pixel = agaa_pixelOf(lane);
    if (!areFew && all(lessThan(pixel, agaa_frame.size)))
        agaa_addPixel(pixel);
    barrier();
    const agaa_Box box = agaa_boxOfTile();
    const bool isEmpty = box.low.x > box.high.x;
    const mat3 toView = inverse(transpose(mat3(agaa_frame.view)));
    for (uint i = lane; i < count; i += 64u)
        if (areFew || (!isEmpty && agaa_reaches(agaa_lightBuffer.lights[i], box, toView))) {
            atomicOr(agaa_tileLights[i >> 5u], 1u << (i & 31u));
            uint map = agaa_lightBuffer.lights[i].shadowMap;
            if (map < AGAA_MAX_SHADOW_MAPS)
                atomicOr(agaa_tileLights[AGAA_LIGHT_WORDS], 1u << map);
        }
    barrier();
    const uint first = agaa_lightMaskAt(gl_WorkGroupID.xy);
    for (uint i = lane; i <= AGAA_LIGHT_WORDS; i += 64u)
        agaa_lightMasks.words[first + i] = agaa_tileLights[i];
}
