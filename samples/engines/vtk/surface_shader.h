/* GLSL of the adapter: VTK's PBR materials as surfaces of the SDK.
 * SPDX-License-Identifier: MIT
 */
#pragma once

namespace agaaVtk {

/* The end of VTK's vertex shader. The inputs that the fragment shader reads inside the primitive are copies: Mesa 22.3
 * displaces plain reads of such inputs, and interpolates them with another w, which a constant 1 measures. */
inline const char vertexDeclarations[] = R"(
invariant gl_Position; // the depths of all passes must be equal
centroid out vec4 insidePosition; // w: 1
centroid out vec3 insideNormal;
)";
inline const char vertexEnd[] = R"(
    insidePosition = vec4(vertexVCVSOutput.xyz, 1.0);
    insideNormal = normalVCVSOutput;
)";

/* The fragment shader, in which VTK replaces its marks. Shading space is VTK's view space. */
inline const char fragmentText[] = R"(//VTK::System::Dec
#define texelFetchBuffer texelFetch
uniform int PrimitiveIDOffset;
//VTK::CustomUniforms::Dec
//VTK::PositionVC::Dec
//VTK::Color::Dec
//VTK::Normal::Dec
//VTK::Light::Dec
//VTK::TMap::Dec
//VTK::TCoord::Dec
//VTK::Output::Dec
centroid in vec4 insidePosition;
centroid in vec3 insideNormal;
void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    vec4 inside = AGAA_INSIDE(insidePosition);
    float scale = 1.0 / inside.w;
    s.position = inside.xyz * scale;
    s.geometricNormal = agaa_planeNormal(AGAA_AT_CENTRE(vertexVCVSOutput).xyz);
#if TEXTURED
    vec2 uv = AGAA_AT_CENTRE(tcoordVCVSOutput); // extrapolates on triangles thinner than a pixel
    vec4 texel = textureGrad(albedoTex, uv, agaa_dFdx(uv), agaa_dFdy(uv));
#if AGAA_ALPHA_MASKED
    s.alpha = texel.a;
    s.alphaCutoff = alphaCutoff;
#endif
#endif
#if AGAA_NEEDS_MATERIAL
    //VTK::Color::Impl
    vec3 albedo = diffuseColor;
#if TEXTURED
    albedo *= texel.rgb;
#endif
    s.diffuse = (1.0 - metallicUniform) * albedo;
    s.specular = mix(vec3(baseF0Uniform), albedo, metallicUniform);
    s.alpha2 = roughnessUniform * roughnessUniform * roughnessUniform * roughnessUniform;
    vec3 n = normalize(AGAA_INSIDE(insideNormal));
    s.normal = gl_FrontFacing ? n : -n;
#endif
    agaa_emit(s);
    OUTPUTS
}
)";

/* VTK's PBR model. It differs from that of the SDK: VTK takes the light that is reflected from the diffuse part, has a
 * masking term of its own, and weakens reflection at grazing angles for reflectances below 0.06. */
inline const char reflectanceText[] = R"(
vec3 agaaReflect(AgaaSurface surface, vec3 toLight, vec3 toEye) {
    vec3 h = normalize(toEye + toLight);
    float noV = clamp(dot(surface.normal, toEye), 1e-5, 1.0), noL = clamp(dot(surface.normal, toLight), 1e-5, 1.0);
    float noH = clamp(dot(surface.normal, h), 1e-5, 1.0), hoL = clamp(dot(h, toLight), 1e-5, 1.0);
    float a2 = surface.alpha2, m2 = sqrt(a2);
    float d = (noH * a2 - noH) * noH + 1.0;
    float masking = noL * sqrt(m2 + noV * (noV - m2 * noV)) + noV * sqrt(m2 + noL * (noL - m2 * noL));
    vec3 f90 = vec3(clamp(dot(surface.specular, vec3(50.0 * 0.33)), 0.0, 1.0));
    vec3 fresnel = surface.specular + (f90 - surface.specular) * pow(1.0 - hoL, 5.0);
    vec3 diffuse = (1.0 - fresnel) * surface.diffuse / 3.14159265;
    return noL * (diffuse + fresnel * (a2 / (3.14159265 * d * d) * 0.5 / masking));
}
)";

} // namespace agaaVtk
