// The GLSL of the suite's hosts. Both draw passes of a frame have the same vertex shader, as
// docs/integration/two-passes.md requires.
#pragma once

#include <cstdint>
#include <string>

namespace agaa::conformance {

// Inputs of both vertex shaders, and outputs for fragments.
inline const std::string vertexAttributes = R"(
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
void setAttributes() {
    position = inPosition;
    normal = inNormal;
    diffuse = inDiffuse;
    specular = inSpecular;
    roughness = inRoughness;
    emissive = inEmissive;
}
)";

// The vertex shader, after "#version 450" and, on OpenGL, `#define ON_OPENGL`.
inline const std::string vertexShader = vertexAttributes + R"(
#ifdef ON_OPENGL
layout(location = 0) uniform mat4 clipFromShading;
#define VERTEX gl_VertexID
#else
layout(push_constant) uniform Push { mat4 clipFromShading; };
#define VERTEX gl_VertexIndex
#endif
invariant gl_Position;
void main() {
    setAttributes();
    primitive = uint(VERTEX) / 3u;
    precise vec4 clip = clipFromShading * vec4(inPosition, 1.0); // same computation as in pullingShader
    gl_Position = clip;
#ifdef MULTICAST
    agaa_multicast();
#endif
}
)";

// Replaces vertexShader, after the version, AgaaDrawPass::glslExtensions and ::glslVertex. An instance is a triangle
// whose corners are attributes, because the vertices of a triangle are consecutive.
inline const std::string pullingShader = vertexAttributes + R"(
#ifdef ON_OPENGL
layout(location = 0) uniform mat4 clipFromShading;
uniform uint firstTriangle;
#define TRIANGLE (firstTriangle + uint(gl_InstanceID))
#define VERTEX gl_VertexID
#else
layout(push_constant) uniform Push { mat4 clipFromShading; };
#define TRIANGLE uint(gl_InstanceIndex)
#define VERTEX gl_VertexIndex
#endif
layout(location = 6) in vec3 inSecondPosition;
layout(location = 7) in vec3 inThirdPosition;
void main() {
    setAttributes();
    primitive = TRIANGLE;
    precise vec4 a = clipFromShading * vec4(inPosition, 1.0);
    precise vec4 b = clipFromShading * vec4(inSecondPosition, 1.0);
    precise vec4 c = clipFromShading * vec4(inThirdPosition, 1.0);
    agaa_pullVertex(a, b, c, uint(VERTEX));
}
)";
constexpr uint32_t stripVertices = 8; // AGAA_MAX_STRIP

// The geometry shader, after the version, AgaaDrawPass::glslExtensions and ::glslGeometry. All vertices of a strip have
// the attributes of the triangle's first corner. The other corners differ only in the position, which the pass does not
// read.
inline const char* const geometryShader = R"(
layout(triangles) in;
layout(triangle_strip, max_vertices = AGAA_MAX_STRIP) out;
layout(location = 0) in vec3 positions[];
layout(location = 1) flat in vec3 normals[];
layout(location = 2) flat in vec4 diffuses[];
layout(location = 3) flat in vec3 speculars[];
layout(location = 4) flat in float roughnesses[];
layout(location = 5) flat in vec3 emissives[];
layout(location = 6) flat in uint primitives[];
layout(location = 0) out vec3 position;
layout(location = 1) flat out vec3 normal;
layout(location = 2) flat out vec4 diffuse;
layout(location = 3) flat out vec3 specular;
layout(location = 4) flat out float roughness;
layout(location = 5) flat out vec3 emissive;
layout(location = 6) flat out uint primitive;
void main() {
    uint count = agaa_beginPrimitive(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
    for (uint i = 0u; i < count; ++i) {
        position = positions[0];
        normal = normals[0];
        diffuse = diffuses[0];
        specular = speculars[0];
        roughness = roughnesses[0];
        emissive = emissives[0];
        primitive = primitives[0];
        agaa_setVertex(i);
        EmitVertex();
    }
}
)";

// AgaaFetchFunction::glsl, with the binding of the buffer of writeScene(). The words of the buffer are those of Vertex.
inline std::string fetchShader(const char* place) {
    return std::string("layout(std430, ") + place +
           R"() readonly buffer SceneBlock { mat4 clipFromShading; float words[]; } scene;
vec3 sceneVector(uint vertex, uint word) {
    uint first = 18u * vertex + word;
    return vec3(scene.words[first], scene.words[first + 1u], scene.words[first + 2u]);
}
vec4 sceneCorner(uint vertex) { return scene.clipFromShading * vec4(sceneVector(vertex, 0u), 1.0); }
void agaaHostTriangle(uint draw, uint primitive, inout vec4 a, inout vec4 b, inout vec4 c) {
    a = sceneCorner(3u * primitive);
    b = sceneCorner(3u * primitive + 1u);
    c = sceneCorner(3u * primitive + 2u);
}
void agaaHostMaterial(AgaaPrimitive p, inout AgaaMaterial m) {
    uint vertex = 3u * p.primitive;
    m.normal = sceneVector(vertex, 3u);
    m.diffuse = sceneVector(vertex, 6u);
    m.specular = sceneVector(vertex, 10u);
    m.alpha2 = scene.words[18u * vertex + 13u];
    m.emissive = sceneVector(vertex, 14u);
}
#ifdef AGAA_EXPANDS_TRIANGLES
void agaaHostDraw(uint draw, inout AgaaDraw d) {
    d.primitives = draw == 0u ? uint(scene.words.length()) / 54u : 0u;
    d.isAlphaMasked = true; // alpha of opaque triangles is 1
}
void agaaHostAlpha(AgaaPrimitive p, inout AgaaAlpha a) {
    a.alpha = scene.words[54u * p.primitive + 9u];
    a.alphaCutoff = 0.5;
    a.primitiveSeed = p.primitive;
}
#endif
)";
}

// The fragment shader, after the version, the extensions, `#define AGAA_ALPHA_MASKED 1` for isMasked, and the
// declarations.
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
#if AGAA_WRITES_IDS || AGAA_HAS_CORNERS
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
