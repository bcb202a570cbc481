// The GLSL of the suite's own hosts. Both draw passes of a frame have the same vertex shader, as docs/integration/two-passes.md
// demands.
#pragma once

namespace agaa::conformance {

// After "#version 450" and, on OpenGL, `#define ON_OPENGL`.
inline const char* const vertexShader = R"(
#ifdef ON_OPENGL
layout(location = 0) uniform mat4 clipFromShading;
#define VERTEX gl_VertexID
#else
layout(push_constant) uniform Push { mat4 clipFromShading; };
#define VERTEX gl_VertexIndex
#endif
layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 2) in vec4 inDiffuse;
layout(location = 3) in vec3 inSpecular;
layout(location = 4) in float inRoughness;
layout(location = 5) in vec3 inEmissive;
layout(location = 0) out vec3 position;
layout(location = 1) flat out vec3 normal;
layout(location = 2) flat out vec4 diffuse;
layout(location = 3) flat out vec3 specular;
layout(location = 4) flat out float roughness;
layout(location = 5) flat out vec3 emissive;
layout(location = 6) flat out uint primitive;
invariant gl_Position;
void main() {
    position = inPosition;
    normal = inNormal;
    diffuse = inDiffuse;
    specular = inSpecular;
    roughness = inRoughness;
    emissive = inEmissive;
    primitive = uint(VERTEX) / 3u;
    gl_Position = clipFromShading * vec4(inPosition, 1.0);
}
)";

// After the version, the extensions, `#define AGAA_ALPHA_MASKED 1` for isMasked, and the declarations.
inline const char* const fragmentShader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) flat in vec3 normal;
layout(location = 2) flat in vec4 diffuse;
layout(location = 3) flat in vec3 specular;
layout(location = 4) flat in float roughness;
layout(location = 5) flat in vec3 emissive;
layout(location = 6) flat in uint primitive;
void main() {
    AgaaSurfaceInput s = agaa_surfaceInput();
    s.position = AGAA_INSIDE(position);
    s.geometricNormal = agaa_planeNormal(position);
    s.alpha = diffuse.a;
    s.alphaCutoff = 0.5;
    s.primitiveSeed = primitive;
#if AGAA_WRITES_IDS
    s.draw = 0u;
    s.primitive = primitive;
#endif
#if AGAA_NEEDS_MATERIAL
    s.diffuse = diffuse.rgb;
    s.specular = specular;
    s.emissive = emissive;
    s.normal = normal;
    s.alpha2 = roughness;
#endif
    agaa_emit(s);
}
)";

} // namespace agaa::conformance
