// Material of the fragments that corners.geom or corners.vert creates. The version, the SDK's extensions,
// interface.glsl, the SDK's declarations, material.glsl and material_inputs.glsl come before this text.

#if AGAA_NEEDS_MATERIAL
VARYING(0) flat in vec4 cornerNormal[3]; // w: u
VARYING(3) flat in vec4 cornerTangent[3];
VARYING(6) flat in vec4 cornerColor[3]; // w: alpha
VARYING(9) flat in vec4 cornerPosition[3]; // w: v
VARYING(12) flat in uvec3 cornerIds; // seed, draw, primitive

vec4 weighed(vec3 weights, vec4 corners[3]) {
    return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
}
vec2 weighedUv(vec3 weights) {
    return weights.x * vec2(cornerNormal[0].w, cornerPosition[0].w) +
           weights.y * vec2(cornerNormal[1].w, cornerPosition[1].w) +
           weights.z * vec2(cornerNormal[2].w, cornerPosition[2].w);
}
float weighedAlpha(vec3 weights) { return dot(weights, vec3(cornerColor[0].w, cornerColor[1].w, cornerColor[2].w)); }
#else
VARYING(0) flat in vec2 cornerUv[3];
VARYING(3) flat in vec3 cornerAlpha;
VARYING(4) flat in uvec3 cornerIds;

vec2 weighedUv(vec3 weights) { return weights.x * cornerUv[0] + weights.y * cornerUv[1] + weights.z * cornerUv[2]; }
float weighedAlpha(vec3 weights) { return dot(weights, cornerAlpha); }
#endif

// The point is clamped to the triangle, because textures may repeat beyond its edges.
float alphaNearCentre(vec2 offset, vec2 dx, vec2 dy) {
    vec3 weights = agaa_cornerWeights(offset).at;
    return alphaAt(weighedAlpha(weights), weighedUv(weights), dx, dy);
}

void setAlpha(inout AgaaSurfaceInput surface) {
    agaa_Barycentrics centre = agaa_cornerWeights(vec2(0.0));
    vec2 dx = weighedUv(centre.dx) * camera.footprint, dy = weighedUv(centre.dy) * camera.footprint;
    surface.alpha = alphaAt(weighedAlpha(centre.at), weighedUv(centre.at), dx, dy);
    if ((features & alphaTestBit) != 0u)
        surface.alphaCutoff = material.alphaCutoff;
    surface.hasAlphaRows = (features & alphaRowsBit) != 0u;
    surface.hasAlphaNear = true; // 64 samples need more than a plane through the centre
    for (uint k = 0u; k < AGAA_ALPHA_POINTS && !surface.hasAlphaRows; ++k)
        surface.alphaNear[k] = alphaNearCentre(agaa_alphaPoint(k), dx, dy);
    for (uint k = 0u; k < 16u && surface.hasAlphaRows; ++k)
        surface.alphaRows[k >> 2u][k & 3u] = alphaNearCentre(agaa_alphaRowPoint(k >> 2u, k & 3u), dx, dy);
}

#if AGAA_NEEDS_MATERIAL
// The material is evaluated at the middle of the covered area.
void setMaterial(inout AgaaSurfaceInput surface) {
    agaa_Barycentrics there = agaa_cornerWeights(agaa_coveredMiddle(surface));
    vec2 uv = weighedUv(there.at);
    vec2 dx = weighedUv(there.dx) * camera.footprint, dy = weighedUv(there.dy) * camera.footprint;
    surface.position = weighed(there.at, cornerPosition).xyz;
    surface.geometricNormal = cross(cornerPosition[1].xyz - cornerPosition[0].xyz,
                                    cornerPosition[2].xyz - cornerPosition[0].xyz);
    SurfacePoint p;
    p.toViewer = viewerDirection(camera.viewer, surface.position);
    p.normal = weighed(there.at, cornerNormal).xyz;
    p.tangent = weighed(there.at, cornerTangent);
    p.color = weighed(there.at, cornerColor).rgb;
    p.isFront = gl_FrontFacing;
    p.isBent = (features & normalBit) != 0u;
    p.baseTexel = p.normalTexel = p.metalRoughTexel = p.emissiveTexel = vec4(1.0);
    if ((features & baseColorBit) != 0u)
        p.baseTexel = textureGrad(baseColorMap, uv, dx, dy);
    if ((features & normalBit) != 0u)
        p.normalTexel = textureGrad(normalMap, uv, dx, dy);
    if ((features & metalRoughBit) != 0u)
        p.metalRoughTexel = textureGrad(metalRoughMap, uv, dx, dy);
    if ((features & emissiveBit) != 0u)
        p.emissiveTexel = textureGrad(emissiveMap, uv, dx, dy);
    SurfaceModel model = surfaceModel(material, p);
    surface.diffuse = model.diffuse;
    surface.specular = model.specular;
    surface.emissive = model.emissive;
    surface.normal = model.normal;
    surface.alpha2 = model.alpha2;
#ifdef MATERIAL_CLASSES
    surface.materialClass = material.materialClass;
#endif
    surface.normalDx = unitNormalChange(p, weighed(there.dx, cornerNormal).xyz);
    surface.normalDy = unitNormalChange(p, weighed(there.dy, cornerNormal).xyz);
}
#endif

void main() {
    AgaaSurfaceInput surface = agaa_surfaceInput();
    surface.primitiveSeed = cornerIds.x;
    surface.draw = cornerIds.y;
    surface.primitive = cornerIds.z;
#if AGAA_ALPHA_MASKED
    setAlpha(surface);
#endif
#if AGAA_NEEDS_MATERIAL
    setMaterial(surface);
#endif
    agaa_emit(surface);
}
