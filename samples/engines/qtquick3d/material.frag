// The engine's own image: the fragment shader of Qt Quick 3D's CustomMaterial. The light processors have the model of
// the SDK, so that the images of both can be compared.
vec3 albedo; // the processor of ambient light has no BASE_COLOR

vec3 reflected(vec3 diffuse, vec3 n, vec3 v, vec3 l) {
    float cosine = max(dot(n, l), 0.0);
    if (cosine <= 0.0)
        return vec3(0.0);
    vec3 h = normalize(v + l);
    float a2 = reflectance.a, noV = clamp(dot(n, v), 1e-4, 1.0), noH = clamp(dot(n, h), 0.0, 1.0);
    vec3 across = cross(n, h);
    float d = max(dot(across, across) + a2 * noH * noH, a2);
    float distribution = a2 / (3.14159265 * d * d);
    float masking = cosine * sqrt(a2 + (1.0 - a2) * noV * noV) + noV * sqrt(a2 + (1.0 - a2) * cosine * cosine);
    float m = 1.0 - clamp(dot(v, h), 0.0, 1.0);
    vec3 fresnel = reflectance.rgb + (1.0 - reflectance.rgb) * (m * m * m * m * m);
    return cosine * (diffuse / 3.14159265 + fresnel * (distribution * 0.5 / max(masking, 1e-7)));
}

void MAIN() {
    vec4 texel = texture(baseColor, UV0);
    if (texel.a < cutoff)
        discard;
    albedo = tint.rgb * texel.rgb;
    BASE_COLOR = vec4(albedo, 1.0);
    SPECULAR_AMOUNT = 0.0; // the light processors add the specular light
}

void AMBIENT_LIGHT() {
    // Qt multiplies the result of this processor by BASE_COLOR.
    DIFFUSE += TOTAL_AMBIENT_COLOR * (albedo + reflectance.rgb) / max(albedo, vec3(1e-4));
}

void DIRECTIONAL_LIGHT() {
    DIFFUSE += reflected(albedo, NORMAL, VIEW_VECTOR, TO_LIGHT_DIR) * LIGHT_COLOR;
}

void POINT_LIGHT() {
    DIFFUSE += reflected(albedo, NORMAL, VIEW_VECTOR, TO_LIGHT_DIR) * LIGHT_COLOR * LIGHT_ATTENUATION;
}

void SPECULAR_LIGHT() {
}
