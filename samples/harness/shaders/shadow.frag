// Fragment shader of alpha-masked casters. Opaque casters are drawn without one.

VARYING(0) in vec2 casterUv;
VARYING(1) in float casterAlpha;

layout(CASTER_AT(0)) uniform sampler2D baseColorMap;
layout(std140, CASTER_AT(4)) uniform Material {
    vec4 baseColor;
    vec3 emissive;
    float metallic;
    float roughness;
    float normalScale;
    float alphaCutoff;
} material;

void main() {
    float alpha = material.baseColor.a * casterAlpha * texture(baseColorMap, casterUv).a;
    // Blended surfaces cast a shadow where they cover more than half.
    if (alpha < mix(material.alphaCutoff, 0.5, float(material.alphaCutoff < 0.0)))
        discard;
}
