// The shadow maps of the frame. Needs AGAA_SHADOWS and common/lights.glsl.
#ifndef AGAA_SHADOW_MAPS_GLSL
#define AGAA_SHADOW_MAPS_GLSL
#if !defined(AGAA_SHADOWS) || !defined(AGAA_LIGHTS_GLSL)
#error "shadow_maps.glsl needs AGAA_SHADOWS and lights.glsl."
#endif
#ifndef AGAA_SHADOW_TEXTURES // 0 if a function of the host returns all shadows
#define AGAA_SHADOW_TEXTURES 1
#endif

#if AGAA_SHADOWS && AGAA_SHADOW_TEXTURES
layout(AGAA_BINDING_SHADOW0) uniform sampler2DArrayShadow agaa_shadowMap0;
layout(AGAA_BINDING_SHADOW1) uniform sampler2DArrayShadow agaa_shadowMap1;
layout(AGAA_BINDING_SHADOW2) uniform sampler2DArrayShadow agaa_shadowMap2;
layout(AGAA_BINDING_SHADOW3) uniform sampler2DArrayShadow agaa_shadowMap3;

// Finds the first layer whose clip volume contains the point. Returns false for points outside all layers, which are
// lit. Points behind a layer's eye (w <= 0) would read the mirrored map (hard case 41).
bool agaa_shadowCoordinate(uint map, vec3 p, out vec4 coordinate) {
    uint layer = 0u; // every map has one
    do {
        vec4 clip = agaa_lightBuffer.shadows[map].matrices[layer] * vec4(p, 1.0);
        if (clip.w > 0.0 && abs(clip.x) <= clip.w && abs(clip.y) <= clip.w && clip.z >= 0.0 && clip.z <= clip.w) {
            vec3 ndc = agaa_quotient3(clip.xyz, clip.w);
            coordinate = vec4(ndc.xy * 0.5 + 0.5, float(layer), ndc.z - agaa_lightBuffer.shadows[map].bias);
            return true;
        }
    } while (++layer < agaa_lightBuffer.shadows[map].layerCount);
    return false;
}

#ifndef AGAA_COMPARE // reads level 0; fragment shaders define it without derivatives, which are undefined in branches
#define AGAA_COMPARE(map, at) texture(map, at)
#endif

// Samplers are separate, because some drivers do not index sampler arrays dynamically.
float agaa_mapTap(uint map, vec3 p) {
    vec4 at;
    if (!agaa_shadowCoordinate(map, p, at))
        return 1.0;
    if (map == 0u)
        return AGAA_COMPARE(agaa_shadowMap0, at);
    if (AGAA_SHADOW_MAPS > 1u && map == 1u)
        return AGAA_COMPARE(agaa_shadowMap1, at);
    if (AGAA_SHADOW_MAPS > 2u && map == 2u)
        return AGAA_COMPARE(agaa_shadowMap2, at);
    return AGAA_COMPARE(agaa_shadowMap3, at);
}
#else
float agaa_mapTap(uint map, vec3 p) { return 1.0; }
#endif
#endif
