// The lights of a frame and their shadows.
#ifndef AGAA_LIGHTS_GLSL
#define AGAA_LIGHTS_GLSL
#include "common/api_values.glsl"

struct agaa_GpuShadow {
    mat4 matrices[AGAA_MAX_SHADOW_LAYERS];
    float bias;
    uint layerCount;
    uint lightCount; // of the frame, in the first
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

// Where the bits of a tile's lights begin. A word follows that has a bit for each shadow whose lights reach the tile.
uint agaa_lightMaskAt(uvec2 tile) {
    return (tile.y * ((agaa_frame.size.x + 7u) / 8u) + tile.x) * (AGAA_LIGHT_WORDS + 1u);
}
#endif
