// The fragments that corners.geom gives to pixels. The version, the SDK's extensions, interface.glsl, the SDK's
// declarations, material.glsl and material_inputs.glsl come before this text.

VARYING(0) flat in vec2 cornerUv[3];
VARYING(3) flat in vec3 cornerAlpha;
VARYING(4) flat in uint cornerSeed;
VARYING(5) flat in uint cornerDraw;

vec2 weighedUv(vec3 weights) { return weights.x * cornerUv[0] + weights.y * cornerUv[1] + weights.z * cornerUv[2]; }

// Inside the triangle: beyond its edges textures may repeat.
float alphaNearCentre(vec2 offset, vec2 dx, vec2 dy) {
    vec3 weights = agaa_cornerWeights(offset).at;
    return alphaAt(dot(weights, cornerAlpha), weighedUv(weights), dx, dy);
}

void setAlpha(inout AgaaSurfaceInput surface) {
    agaa_Barycentrics centre = agaa_cornerWeights(vec2(0.0));
    vec2 dx = weighedUv(centre.dx) * camera.footprint, dy = weighedUv(centre.dy) * camera.footprint;
    surface.alpha = alphaAt(dot(centre.at, cornerAlpha), weighedUv(centre.at), dx, dy);
    if ((features & alphaTestBit) != 0u)
        surface.alphaCutoff = material.alphaCutoff;
    surface.hasAlphaRows = (features & alphaRowsBit) != 0u;
    surface.hasAlphaNear = true; // 64 samples want more than a plane through the centre
    for (uint k = 0u; k < AGAA_ALPHA_POINTS && !surface.hasAlphaRows; ++k)
        surface.alphaNear[k] = alphaNearCentre(agaa_alphaPoint(k), dx, dy);
    for (uint k = 0u; k < 16u && surface.hasAlphaRows; ++k)
        surface.alphaRows[k >> 2u][k & 3u] = alphaNearCentre(agaa_alphaRowPoint(k >> 2u, k & 3u), dx, dy);
}

void main() {
    AgaaSurfaceInput surface = agaa_surfaceInput();
    surface.primitiveSeed = cornerSeed;
    surface.draw = cornerDraw;
    surface.primitive = uint(gl_PrimitiveID);
#if AGAA_ALPHA_MASKED
    setAlpha(surface);
#endif
    agaa_emit(surface);
}
