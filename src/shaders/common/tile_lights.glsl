// The lights that may reach the geometry of a workgroup's tile, in shared memory. All 64 lanes call
// agaa_beginTileLights(), add the geometry, and call agaa_findTileLights(). If AGAA_LIGHT_WORDS is 0, nothing is found.
// Needs common/frame.glsl and common/lights.glsl.
#ifndef AGAA_TILE_LIGHTS_GLSL
#define AGAA_TILE_LIGHTS_GLSL
#if !defined(AGAA_FRAME_GLSL) || !defined(AGAA_LIGHTS_GLSL)
#error "tile_lights.glsl needs frame.glsl and lights.glsl."
#endif
#include "math/light_culling.glsl"
#include "math/ordered_bits.glsl"
#include "tables/lighting.inc"

// Bounding box in view space.
struct agaa_Box {
    vec3 low, high;
};
shared uint agaa_tileBox[6];
shared uint agaa_tileLights[AGAA_LIGHT_WORDS + 1u]; // bits of lights; the last word is the mask of their shadows

agaa_Box agaa_emptyBox() { return agaa_Box(vec3(3.0e38), vec3(-3.0e38)); }

void agaa_addToBox(inout agaa_Box box, vec3 at) {
    box.low = min(box.low, at);
    box.high = max(box.high, at);
}

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

// Few lights are all evaluated.
bool agaa_areLightsFew() { return agaa_lightBuffer.shadows[0].lightCount < AGAA_LEAST_CULLED_LIGHTS; }

// Returns whether the geometry of the tile is needed.
bool agaa_needsTileBox() { return AGAA_LIGHT_WORDS != 0u && !agaa_areLightsFew(); }

void agaa_beginTileLights() {
    if (AGAA_LIGHT_WORDS == 0u)
        return;
    const uint lane = gl_LocalInvocationIndex;
    for (uint i = lane; i <= AGAA_LIGHT_WORDS; i += 64u)
        agaa_tileLights[i] = 0u;
    if (lane < 6u)
        agaa_tileBox[lane] = agaa_orderedBits(lane < 3u ? 3.0e38 : -3.0e38);
    barrier();
}

// Readers of the lights need a barrier.
void agaa_findTileLights() {
    if (AGAA_LIGHT_WORDS == 0u)
        return;
    barrier();
    const agaa_Box box = agaa_boxOfTile();
    const bool isEmpty = box.low.x > box.high.x;
    const bool areFew = agaa_areLightsFew();
    const mat3 toView = inverse(transpose(mat3(agaa_frame.view)));
    for (uint i = gl_LocalInvocationIndex; i < agaa_lightBuffer.shadows[0].lightCount; i += 64u)
        if (areFew || (!isEmpty && agaa_reaches(agaa_lightBuffer.lights[i], box, toView))) {
            atomicOr(agaa_tileLights[i >> 5u], 1u << (i & 31u));
            uint map = agaa_lightBuffer.lights[i].shadowMap;
            if (map < AGAA_MAX_SHADOW_MAPS)
                atomicOr(agaa_tileLights[AGAA_LIGHT_WORDS], 1u << map);
        }
}
#endif
