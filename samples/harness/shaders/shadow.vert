// Casters of shadows. The version and interface.glsl come before this text.

LOCATION(0) in vec3 vertexPosition;
LOCATION(3) in vec2 vertexUv;
LOCATION(4) in vec4 vertexColor;
VARYING(0) out vec2 casterUv;
VARYING(1) out float casterAlpha;

DRAW_BLOCK Draw { mat4 toClip; } draw;

void main() {
    gl_Position = draw.toClip * vec4(vertexPosition, 1.0);
    casterUv = vertexUv;
    casterAlpha = vertexColor.a;
}
