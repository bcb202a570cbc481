// The material for the SDK's draw passes. The mesh renderer puts the version, the SDK's declarations and the properties
// of the CustomMaterial before this text.
layout(location = 0) in vec3 centrePosition;
layout(location = 1) in vec2 centreUv;
layout(location = 2) centroid in vec4 insidePosition;
layout(location = 3) centroid in vec3 insideNormal;
layout(location = 4) centroid in vec2 insideUv;

vec3 shadingNormal(vec3 n, vec3 position) {
    n = normalize(n);
    return isTwoSided > 0.5 && dot(n, position) > 0.0 ? -n : n;
}

void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    vec4 inside = AGAA_INSIDE(insidePosition);
    float scale = 1.0 / inside.w;
    precise vec2 uvAtCentre = AGAA_AT_CENTRE(centreUv);
    precise vec2 dx = agaa_dFdx(uvAtCentre), dy = agaa_dFdy(uvAtCentre);
    s.position = inside.xyz * scale;
    s.geometricNormal = agaa_planeNormal(AGAA_AT_CENTRE(centrePosition));
#if AGAA_ALPHA_MASKED
    s.alpha = textureGrad(baseColor, uvAtCentre, dx, dy).a;
    s.alphaCutoff = cutoff;
#endif
#if AGAA_NEEDS_MATERIAL
    s.diffuse = tint.rgb * textureGrad(baseColor, AGAA_INSIDE(insideUv) * scale, dx, dy).rgb;
    s.specular = reflectance.rgb;
    s.alpha2 = reflectance.a;
    s.normal = shadingNormal(AGAA_INSIDE(insideNormal), s.position);
#endif
    agaa_emit(s);
}
