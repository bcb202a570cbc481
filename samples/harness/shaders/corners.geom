// A fragment for each pixel that a triangle touches, which gets what its material needs at the three corners. The SDK's
// geometry text and interface.glsl come before this text.

layout(triangles) in;
layout(triangle_strip, max_vertices = AGAA_MAX_STRIP) out;

VARYING(1) in vec2 centreUv[];
VARYING(2) in float centreAlpha[];
VARYING(8) flat in uint primitiveSeed[];
VARYING(9) flat in uint drawIndex[];

VARYING(0) flat out vec2 cornerUv[3];
VARYING(3) flat out vec3 cornerAlpha;
VARYING(4) flat out uint cornerSeed;
VARYING(5) flat out uint cornerDraw;

void main() {
    uint count = agaa_beginPrimitive(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
    for (uint i = 0u; i < count; ++i) {
        for (int corner = 0; corner < 3; ++corner)
            cornerUv[corner] = centreUv[corner];
        cornerAlpha = vec3(centreAlpha[0], centreAlpha[1], centreAlpha[2]);
        cornerSeed = primitiveSeed[0];
        cornerDraw = drawIndex[0];
        gl_PrimitiveID = gl_PrimitiveIDIn;
        agaa_setVertex(i);
        EmitVertex();
    }
}
