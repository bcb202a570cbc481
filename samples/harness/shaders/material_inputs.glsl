// Inputs of the material's fragment shaders from the engine. material.glsl comes before this text.

layout(MATERIAL_AT(0)) uniform sampler2D baseColorMap;
layout(MATERIAL_AT(1)) uniform sampler2D normalMap;
layout(MATERIAL_AT(2)) uniform sampler2D metalRoughMap;
layout(MATERIAL_AT(3)) uniform sampler2D emissiveMap;
layout(std140, MATERIAL_AT(4)) uniform Material { MaterialValues material; };

layout(std140, CAMERA_AT) uniform Camera {
    mat4 viewProjection;
    vec4 viewer; // homogeneous position in shading space
    float footprint; // width of the textures' footprint, as a share of the pixel
    float unitDistance; // of images of motion
    vec2 jitter; // by which the projection moves the image, in clip space
} camera;

// Bits of the material: base colour, normal, metallic-roughness and emissive map, alpha test at the cutoff, and alpha
// test at four points of a texel. It is a constant of the pipeline: drivers that specialise shaders by the uniforms in
// their conditions, such as Mesa 22.3's lavapipe, would otherwise compile at every change of material.
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

// Alpha is read at the texel's centre, or near it. All other inputs are evaluated inside the primitive. The samples
// that survive the depth test, and so the point inside, differ between passes, but all passes must agree about
// coverage. The function is precise, because each pass is a separate program.
float alphaAt(float vertexAlpha, vec2 uv, vec2 dx, vec2 dy) {
    precise float alpha = material.baseColor.a * clamp(vertexAlpha, 0.0, 1.0);
    if ((features & baseColorBit) != 0u)
        alpha *= textureGrad(baseColorMap, uv, dx, dy).a;
    return alpha;
}
