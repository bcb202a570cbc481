// What the material's fragment shaders read of the engine. material.glsl comes before this text.

layout(MATERIAL_AT(0)) uniform sampler2D baseColorMap;
layout(MATERIAL_AT(1)) uniform sampler2D normalMap;
layout(MATERIAL_AT(2)) uniform sampler2D metalRoughMap;
layout(MATERIAL_AT(3)) uniform sampler2D emissiveMap;
layout(std140, MATERIAL_AT(4)) uniform Material { MaterialValues material; };

// footprint: of textures, as a part of the pixel's.
layout(std140, CAMERA_AT) uniform Camera { mat4 viewProjection; float footprint; } camera;

// What the material has, by bits: base colour, normal, metallic-roughness and emissive map, alpha tested
// at the cutoff, and at four points of a texel. A constant of the pipeline: drivers that specialise shaders by the uniforms in their
// conditions, as Mesa 22.3's lavapipe, would compile at every change of material.
#ifdef FEATURES
const uint features = FEATURES;
#else
layout(constant_id = 0) const uint features = 0u;
#endif

const uint baseColorBit = 1u;
const uint normalBit = 2u;
const uint metalRoughBit = 4u;
const uint emissiveBit = 8u;
const uint alphaTestBit = 16u;
const uint alphaNearBit = 32u;
const uint alphaRowsBit = 64u;

// Alpha is taken at the texel's centre, or near it. Everything else is evaluated inside the primitive, but which samples
// survive the depth test, and so what counts as inside, differs between passes, and all passes must agree about
// coverage. Precise, since each pass is a program of its own.
float alphaAt(float vertexAlpha, vec2 uv, vec2 dx, vec2 dy) {
    precise float alpha = material.baseColor.a * clamp(vertexAlpha, 0.0, 1.0);
    if ((features & baseColorBit) != 0u)
        alpha *= textureGrad(baseColorMap, uv, dx, dy).a;
    return alpha;
}
