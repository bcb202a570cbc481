// The lights of a frame and their shadows. Needs common/frame.glsl, and AGAA_BINDING_LIGHTS or AGAA_LIGHT_BLOCK.
#ifndef AGAA_LIGHTS_GLSL
#define AGAA_LIGHTS_GLSL
#ifndef AGAA_FRAME_GLSL
#error "lights.glsl needs frame.glsl."
#endif
#if !defined(AGAA_BINDING_LIGHTS) && !defined(AGAA_LIGHT_BLOCK)
#error "lights.glsl needs AGAA_BINDING_LIGHTS or AGAA_LIGHT_BLOCK."
#endif
#include "common/api_values.glsl"

struct agaa_GpuShadow {
    mat4 matrices[AGAA_MAX_SHADOW_LAYERS];
    float bias;
    uint layerCount;
    uint lightCount; // of the frame; only in the first shadow
    uint padding;
};
struct agaa_GpuLight {
    vec3 position;
    float range; // 0: it has no end
    vec3 direction; // from the light
    uint type;      // AgaaLightType
    vec3 color;
    uint shadowMap; // AGAA_MAX_SHADOW_MAPS or more: none
    float cosInner, cosOuter;
    float radius;
    float padding;
};
#ifndef AGAA_LIGHT_BLOCK
#define AGAA_LIGHT_BLOCK layout(std430, AGAA_BINDING_LIGHTS) readonly buffer
#define AGAA_LIGHT_COUNT
#endif
AGAA_LIGHT_BLOCK agaa_LightBlock {
    agaa_GpuShadow shadows[AGAA_MAX_SHADOW_MAPS];
    agaa_GpuLight lights[AGAA_LIGHT_COUNT];
} agaa_lightBuffer;

// Returns the index of the first word of a tile's mask of lights. The mask of shadows whose lights reach the tile
// follows.
uint agaa_lightMaskAt(uvec2 tile) {
    return (tile.y * ((agaa_frame.size.x + 7u) / 8u) + tile.x) * (AGAA_LIGHT_WORDS + 1u);
}
#endif
