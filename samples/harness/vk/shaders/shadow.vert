#version 450

layout(location = 0) in vec3 vertexPosition;
layout(location = 3) in vec2 vertexUv;
layout(location = 4) in vec4 vertexColor;
layout(location = 0) out vec2 outUv;
layout(location = 1) out float outAlpha;

layout(push_constant) uniform Draw { mat4 toClip; } draw;

void main() {
    gl_Position = draw.toClip * vec4(vertexPosition, 1.0);
    outUv = vertexUv;
    outAlpha = vertexColor.a;
}
