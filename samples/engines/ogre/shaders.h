/* The engine's shaders. The adapter knows only that the fragment shader has a part for AGAA_PASS.
 * SPDX-License-Identifier: MIT
 */
#pragma once

/* All passes share the vertex shader, because their depths must be equal. Inputs that a fragment shader reads inside
 * the primitive are passed twice: Mesa 22.3 displaces plain reads of such inputs, and interpolates them with another w,
 * which a constant 1 measures. */
inline const char vertexText[] = R"(#version 450
in vec4 vertex;
in vec3 normal;
in vec2 uv0;
uniform mat4 world;
uniform mat4 normalMatrix; // inverse transpose of world
uniform mat4 viewProjection;
uniform vec3 eye;
out vec3 centrePosition; // shading space: the world's axes, the origin at the eye
out vec2 centreUv;
centroid out vec4 insidePosition; // w: 1
centroid out vec3 insideNormal;
centroid out vec2 insideUv;
invariant gl_Position;
void main() {
    vec4 place = world * vertex;
    centrePosition = place.xyz - eye;
    insidePosition = vec4(centrePosition, 1.0);
    insideNormal = mat3(normalMatrix) * normal;
    centreUv = insideUv = uv0;
    gl_Position = viewProjection * place;
}
)";

inline const char fragmentText[] = R"(#version 450
uniform sampler2D baseColor;
uniform vec4 tint;
uniform vec4 reflectance; // rgb: at normal incidence, a: GGX alpha squared
uniform float cutoff;     // 0: opaque
uniform float isTwoSided; // 1: the normal faces the eye
in vec3 centrePosition;
in vec2 centreUv;
centroid in vec4 insidePosition;
centroid in vec3 insideNormal;
centroid in vec2 insideUv;

vec3 shadingNormal(vec3 n, vec3 position) {
    n = normalize(n);
    return isTwoSided > 0.5 && dot(n, position) > 0.0 ? -n : n;
}

#ifdef AGAA_PASS
void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    vec4 inside = AGAA_INSIDE(insidePosition);
    float scale = 1.0 / inside.w;
    vec2 uvAtCentre = AGAA_AT_CENTRE(centreUv);
    vec2 dx = agaa_dFdx(uvAtCentre), dy = agaa_dFdy(uvAtCentre);
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
#else
// The engine's own image. The lights have the model of the SDK, so that the images of both can be compared.
uniform vec4 lightPosition[3]; // world; w = 0: the direction to a directional light
uniform vec4 lightColor[3];
uniform vec4 lightAttenuation[3]; // x: range
uniform vec4 ambient;
uniform vec3 lightEye;
out vec4 color;

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

void main() {
    vec4 texel = texture(baseColor, centreUv);
    if (texel.a < cutoff)
        discard;
    vec3 diffuse = tint.rgb * texel.rgb;
    vec3 n = shadingNormal(insideNormal, centrePosition);
    vec3 v = normalize(-centrePosition);
    vec3 sum = ambient.rgb * (diffuse + reflectance.rgb);
    for (int i = 0; i < 3; ++i) {
        vec3 toLight = lightPosition[i].xyz;
        float intensity = 1.0;
        if (lightPosition[i].w != 0.0) {
            toLight -= lightEye + centrePosition;
            float d2 = max(dot(toLight, toLight), 1e-20);
            float range = lightAttenuation[i].x;
            float window = min(d2 / (range * range), 1.0);
            intensity = (1.0 - window * window) * (1.0 - window * window) / d2;
        }
        sum += reflected(diffuse, n, v, normalize(toLight)) * lightColor[i].rgb * intensity;
    }
    color = vec4(sum, 1.0);
}
#endif
)";
