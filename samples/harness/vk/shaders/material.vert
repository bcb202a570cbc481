#version 450
// The sample engine's one vertex shader for all passes that must agree on depth.

layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec3 vertexNormal;
layout(location = 2) in vec4 vertexTangent;
layout(location = 3) in vec2 vertexUv;
layout(location = 4) in vec4 vertexColor;

layout(location = 0) out vec3 outPosition; // shading space
layout(location = 1) out vec3 outNormal;
layout(location = 2) out vec4 outTangent;
layout(location = 3) out vec2 outUv;
layout(location = 4) out vec4 outColor;
layout(location = 5) flat out uint outSeed;
layout(location = 6) out float outOne; // see insideScale() in material.frag

layout(set = 0, binding = 0, std140) uniform Camera { mat4 viewProjection; } camera;

layout(push_constant) uniform Draw {
    vec4 toShading[3];      // rows of object to shading space
    vec4 normalToShading[3]; // rows of the inverse transpose
    uint seed;
    float handedness; // -1 where the transform mirrors
} draw;

invariant gl_Position;

void main() {
    vec4 position = vec4(vertexPosition, 1.0);
    outPosition = vec3(dot(draw.toShading[0], position), dot(draw.toShading[1], position),
                       dot(draw.toShading[2], position));
    gl_Position = camera.viewProjection * vec4(outPosition, 1.0);
    outNormal = vec3(dot(draw.normalToShading[0].xyz, vertexNormal),
                     dot(draw.normalToShading[1].xyz, vertexNormal),
                     dot(draw.normalToShading[2].xyz, vertexNormal));
    outTangent = vec4(dot(draw.toShading[0].xyz, vertexTangent.xyz),
                      dot(draw.toShading[1].xyz, vertexTangent.xyz),
                      dot(draw.toShading[2].xyz, vertexTangent.xyz),
                      vertexTangent.w * draw.handedness);
    outUv = vertexUv;
    outColor = vertexColor;
    outOne = 1.0;
    // Of the primitive's first vertex.
    uint seed = (draw.seed ^ uint(gl_VertexIndex)) * 0x9E3779B1u;
    outSeed = seed ^ (seed >> 15);
}
