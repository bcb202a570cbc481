#version 450
// Alpha-masked casters only; opaque ones are drawn without a fragment shader.

layout(location = 0) in vec2 inUv;
layout(location = 1) in float inAlpha;

layout(set = 0, binding = 0) uniform sampler2D baseColorMap;
layout(set = 0, binding = 4, std140) uniform Material {
    vec4 baseColor;
    vec3 emissive;
    float metallic;
    float roughness;
    float normalScale;
    float alphaCutoff;
} material;

void main() {
    float alpha = material.baseColor.a * inAlpha * texture(baseColorMap, inUv).a;
    // What is blended casts a shadow where it covers more than half.
    if (alpha < mix(material.alphaCutoff, 0.5, float(material.alphaCutoff < 0.0)))
        discard;
}
