#version 450
// The sample engine's one vertex shader for all passes that must agree on depth.

layout(location = 0) in vec3 vertexPosition;
layout(location = 1) in vec3 vertexNormal;
layout(location = 2) in vec4 vertexTangent;
layout(location = 3) in vec2 vertexUv;
layout(location = 4) in vec4 vertexColor;

// Read at the pixel's centre. Positions and vectors are in shading space.
layout(location = 0) out vec3 outPosition;
layout(location = 1) out vec2 outUv;
layout(location = 2) out float outAlpha;
// Read inside the primitive; see material.frag for why these are not the same.
layout(location = 3) out vec4 outInsidePosition; // w: 1
layout(location = 4) out vec3 outInsideNormal;
layout(location = 5) out vec4 outInsideTangent;
layout(location = 6) out vec2 outInsideUv;
layout(location = 7) out vec3 outInsideColor;
layout(location = 8) flat out uint outSeed;

layout(set = 0, binding = 0, std140) uniform Camera { mat4 viewProjection; } camera;

layout(push_constant) uniform Draw {
    vec4 toShading[3];       // rows of object to shading space
    vec4 normalToShading[3]; // rows of the inverse transpose
    uint seed;
    float handedness; // -1 where the transform mirrors
} draw;

invariant gl_Position;

vec3 rotate(vec4 rows[3], vec3 v) {
    return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v));
}

void main() {
    vec4 position = vec4(vertexPosition, 1.0);
    outPosition = vec3(dot(draw.toShading[0], position), dot(draw.toShading[1], position),
                       dot(draw.toShading[2], position));
    gl_Position = camera.viewProjection * vec4(outPosition, 1.0);
    outUv = vertexUv;
    outAlpha = vertexColor.a;

    outInsidePosition = vec4(outPosition, 1.0);
    outInsideNormal = rotate(draw.normalToShading, vertexNormal);
    outInsideTangent = vec4(rotate(draw.toShading, vertexTangent.xyz),
                            vertexTangent.w * draw.handedness);
    outInsideUv = vertexUv;
    outInsideColor = vertexColor.rgb;
    // Of the primitive's first vertex.
    uint seed = (draw.seed ^ uint(gl_VertexIndex)) * 0x9E3779B1u;
    outSeed = seed ^ (seed >> 15);
}
