// The sample engine's metallic-roughness material. The version, the SDK's extensions, interface.glsl and the
// SDK's declarations come before this text.

// Two sets of inputs, because Mesa's software rasteriser (22.3) has two faults at the edges of triangles.
// Where a shader reads an input inside the primitive, plain reads of the same input, and so their
// derivatives, are displaced too: what is read both ways comes twice.
VARYING(0) in vec3 centrePosition; // shading space
VARYING(1) in vec2 centreUv;
VARYING(2) in float centreAlpha;
// And it interpolates inside with the 1/w of the pixel's centre: values come out too large by the factor
// by which a constant 1 does, so one is sent along. Elsewhere it is 1.
VARYING(3) centroid in vec4 insidePosition; // w: 1
VARYING(4) centroid in vec3 insideNormal;
VARYING(5) centroid in vec4 insideTangent;
VARYING(6) centroid in vec2 insideUv;
VARYING(7) centroid in vec3 insideColor;
VARYING(8) flat in uint primitiveSeed;

layout(MATERIAL_AT(0)) uniform sampler2D baseColorMap;
layout(MATERIAL_AT(1)) uniform sampler2D normalMap;
layout(MATERIAL_AT(2)) uniform sampler2D metalRoughMap;
layout(MATERIAL_AT(3)) uniform sampler2D emissiveMap;
layout(std140, MATERIAL_AT(4)) uniform Material {
    vec4 baseColor;
    vec3 emissive;
    float metallic;
    float roughness;
    float normalScale;
    float alphaCutoff; // < 0: alpha is coverage as it is
} material;

// What the material has, by bits: base colour, normal, metallic-roughness and emissive map, alpha tested
// at the cutoff. A constant of the pipeline: drivers that specialise shaders by the uniforms in their
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

// Of the pixel's centre, unlike all else: the samples that survive the depth test, and so what counts as
// inside, differ between the passes, and a sample that one pass covers must be covered in the next.
float coverage(vec2 uv, vec2 dx, vec2 dy) {
    float alpha = material.baseColor.a * clamp(AGAA_AT_CENTRE(centreAlpha), 0.0, 1.0);
    if ((features & baseColorBit) != 0u)
        alpha *= textureGrad(baseColorMap, uv, dx, dy).a;
    if ((features & alphaTestBit) != 0u)
        alpha = agaa_sharpenAlpha(alpha, material.alphaCutoff);
    return alpha;
}

vec3 baseColor(float scale, vec2 uv, vec2 dx, vec2 dy) {
    vec3 color = material.baseColor.rgb * max(AGAA_INSIDE(insideColor) * scale, vec3(0.0));
    if ((features & baseColorBit) != 0u)
        color *= textureGrad(baseColorMap, uv, dx, dy).rgb;
    return color;
}

// The vertex normal n bent by the normal map.
vec3 mappedNormal(vec3 n, vec2 uv, vec2 dx, vec2 dy) {
    vec4 tangent = AGAA_INSIDE(insideTangent);
    vec3 t = tangent.xyz - n * dot(n, tangent.xyz);
    float tangentSquared = dot(t, t);
    if (tangentSquared <= 0.0)
        return n;
    t *= inversesqrt(tangentSquared);
    vec3 b = cross(n, t) * (tangent.w < 0.0 ? -1.0 : 1.0);
    vec3 m = textureGrad(normalMap, uv, dx, dy).xyz * 2.0 - 1.0;
    m.xy *= material.normalScale;
    vec3 bent = t * m.x + b * m.y + n * m.z;
    float bentSquared = dot(bent, bent);
    return bentSquared > 1e-8 ? bent * inversesqrt(bentSquared) : n;
}

vec3 shadingNormal(vec3 position, vec2 uv, vec2 dx, vec2 dy) {
    vec3 toViewer = normalize(-position);
    vec3 vertexNormal = AGAA_INSIDE(insideNormal);
    float squared = dot(vertexNormal, vertexNormal);
    vec3 n = squared > 0.0 ? vertexNormal * inversesqrt(squared) : toViewer;
    if ((features & normalBit) != 0u)
        n = mappedNormal(n, uv, dx, dy);
    if (!gl_FrontFacing)
        n = -n; // glTF's rule for the back of double-sided materials
    // Interpolation and normal maps may turn it away from the viewer: bend it onto the horizon.
    float facing = dot(n, toViewer);
    return facing < 0.0 ? normalize(n - toViewer * (facing - 1e-3)) : n;
}

void main() {
    AgaaSurfaceInput surface = agaa_surfaceInput();
    vec4 inside = AGAA_INSIDE(insidePosition);
    float scale = 1.0 / inside.w;
    // Gradients belong to the plain input: from pixel to pixel, the place inside jumps.
    vec2 uvAtCentre = AGAA_AT_CENTRE(centreUv);
    vec2 dx = agaa_dFdx(uvAtCentre);
    vec2 dy = agaa_dFdy(uvAtCentre);
    surface.position = inside.xyz * scale;
    surface.geometricNormal = agaa_planeNormal(AGAA_AT_CENTRE(centrePosition));
    surface.primitiveSeed = primitiveSeed;

#if AGAA_ALPHA_MASKED
    surface.alpha = coverage(uvAtCentre, dx, dy);
#endif
#if AGAA_NEEDS_MATERIAL
    // At the pixel's centre they extrapolate where the primitive is thinner than a pixel.
    vec2 uv = AGAA_INSIDE(insideUv) * scale;
    vec3 base = baseColor(scale, uv, dx, dy);
    float metallic = material.metallic;
    float roughness = material.roughness;
    if ((features & metalRoughBit) != 0u) {
        vec4 metalRough = textureGrad(metalRoughMap, uv, dx, dy);
        metallic *= metalRough.b;
        roughness *= metalRough.g;
    }
    surface.diffuse = base * (1.0 - metallic);
    surface.specular = mix(vec3(0.04), base, metallic);
    surface.emissive = material.emissive;
    if ((features & emissiveBit) != 0u)
        surface.emissive *= textureGrad(emissiveMap, uv, dx, dy).rgb;
    surface.normal = shadingNormal(surface.position, uv, dx, dy);
    // Below this the highlight of a light without extent has no width.
    float alpha = max(roughness, 0.089);
    alpha *= alpha;
    surface.alpha2 = alpha * alpha;
#endif
    agaa_emit(surface);
#ifdef COPY_OUTPUTS
    COPY_OUTPUTS // where the host declares the outputs
#endif
}
