// The sample engine's metallic-roughness material. The version, the SDK's extensions and its
// declarations come before this text.

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inTangent;
layout(location = 3) in vec2 inUv;
layout(location = 4) in vec4 inColor;
layout(location = 5) flat in uint inSeed;
layout(location = 6) in float inOne;

layout(set = 2, binding = 0) uniform sampler2D baseColorMap;
layout(set = 2, binding = 1) uniform sampler2D normalMap;
layout(set = 2, binding = 2) uniform sampler2D metalRoughMap;
layout(set = 2, binding = 3) uniform sampler2D emissiveMap;
layout(set = 2, binding = 4, std140) uniform Material {
    vec4 baseColor;
    vec3 emissive;
    float metallic;
    float roughness;
    float normalScale;
    float alphaCutoff; // < 0: alpha is coverage as it is
    uint maps;         // bits: base colour, normal, metallic-roughness, emissive
} material;

const uint baseColorBit = 1u;
const uint normalBit = 2u;
const uint metalRoughBit = 4u;
const uint emissiveBit = 8u;

// Mesa's software rasteriser (22.3) interpolates at a centroid or sample with the 1/w of the pixel's
// centre: a value comes out too large by the factor that a constant 1 comes out by. Elsewhere this is 1.
float insideScale() { return 1.0 / AGAA_INSIDE(inOne); }

// Texture coordinates are taken inside the primitive: at the pixel's centre they extrapolate where
// the primitive is thinner than a pixel.
vec4 baseColor(vec2 uv, vec2 dx, vec2 dy) {
    vec4 color = material.baseColor * max(AGAA_INSIDE(inColor) * insideScale(), vec4(0.0));
    if ((material.maps & baseColorBit) != 0u)
        color *= textureGrad(baseColorMap, uv, dx, dy);
    return color;
}

vec3 shadingNormal(vec3 position, vec2 uv, vec2 dx, vec2 dy) {
    vec3 vertexNormal = AGAA_INSIDE(inNormal);
    float squared = dot(vertexNormal, vertexNormal);
    vec3 n = squared > 0.0 ? vertexNormal * inversesqrt(squared) : normalize(-position);
    if ((material.maps & normalBit) != 0u) {
        vec4 tangent = AGAA_INSIDE(inTangent);
        vec3 t = tangent.xyz - n * dot(n, tangent.xyz);
        float tangentSquared = dot(t, t);
        if (tangentSquared > 0.0) {
            t *= inversesqrt(tangentSquared);
            vec3 b = cross(n, t) * (tangent.w < 0.0 ? -1.0 : 1.0);
            vec3 m = textureGrad(normalMap, uv, dx, dy).xyz * 2.0 - 1.0;
            m.xy *= material.normalScale;
            vec3 bent = t * m.x + b * m.y + n * m.z;
            float bentSquared = dot(bent, bent);
            if (bentSquared > 1e-8)
                n = bent * inversesqrt(bentSquared);
        }
    }
    if (!gl_FrontFacing)
        n = -n; // glTF's rule for the back of double-sided materials
    // Interpolation and normal maps may turn it away from the viewer: bend it onto the horizon.
    vec3 toViewer = normalize(-position);
    float facing = dot(n, toViewer);
    if (facing < 0.0) {
        n -= toViewer * (facing - 1e-3);
        n = normalize(n);
    }
    return n;
}

void main() {
    AgaaSurfaceInput surface = agaa_surfaceInput();
    vec2 uv = AGAA_INSIDE(inUv) * insideScale();
    vec2 dx = agaa_dFdx(inUv);
    vec2 dy = agaa_dFdy(inUv);
    surface.position = AGAA_INSIDE(inPosition) * insideScale();
    surface.geometricNormal = agaa_planeNormal(inPosition);
    surface.primitiveSeed = inSeed;

#if AGAA_NEEDS_MATERIAL || AGAA_ALPHA_MASKED
    vec4 base = baseColor(uv, dx, dy);
#endif
#if AGAA_ALPHA_MASKED
    surface.alpha = material.alphaCutoff < 0.0
                        ? base.a
                        : agaa_sharpenAlpha(base.a, material.alphaCutoff);
#endif
#if AGAA_NEEDS_MATERIAL
    float metallic = material.metallic;
    float roughness = material.roughness;
    if ((material.maps & metalRoughBit) != 0u) {
        vec4 metalRough = textureGrad(metalRoughMap, uv, dx, dy);
        metallic *= metalRough.b;
        roughness *= metalRough.g;
    }
    surface.diffuse = base.rgb * (1.0 - metallic);
    surface.specular = mix(vec3(0.04), base.rgb, metallic);
    surface.emissive = material.emissive;
    if ((material.maps & emissiveBit) != 0u)
        surface.emissive *= textureGrad(emissiveMap, uv, dx, dy).rgb;
    surface.normal = shadingNormal(surface.position, uv, dx, dy);
    // Below this the highlight of a light without extent has no width.
    float alpha = max(roughness, 0.089);
    alpha *= alpha;
    surface.alpha2 = alpha * alpha;
#endif
    agaa_emit(surface);
}
