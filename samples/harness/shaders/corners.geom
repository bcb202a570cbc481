// A fragment for each pixel that a triangle touches, which gets what its material needs at the three corners. The SDK's
// geometry text and interface.glsl come before this text.

layout(triangles) in;
layout(triangle_strip, max_vertices = AGAA_MAX_STRIP) out;

VARYING(1) in vec2 centreUv[];
VARYING(2) in float centreAlpha[];
VARYING(8) flat in uint primitiveSeed[];
VARYING(9) flat in uint drawIndex[];

#if AGAA_NEEDS_MATERIAL
VARYING(0) in vec3 centrePosition[];
VARYING(4) in vec3 insideNormal[];
VARYING(5) in vec4 insideTangent[];
VARYING(7) in vec3 insideColor[];

// Thirteen locations, because three belong to the SDK and devices need not have more than 16.
VARYING(0) flat out vec4 cornerNormal[3]; // w: u
VARYING(3) flat out vec4 cornerTangent[3];
VARYING(6) flat out vec4 cornerColor[3]; // w: alpha
VARYING(9) flat out vec4 cornerPosition[3]; // w: v
VARYING(12) flat out uvec2 cornerIds; // seed, draw

void setCorners() {
    for (int corner = 0; corner < 3; ++corner) {
        cornerNormal[corner] = vec4(insideNormal[corner], centreUv[corner].x);
        cornerTangent[corner] = insideTangent[corner];
        cornerColor[corner] = vec4(insideColor[corner], centreAlpha[corner]);
        cornerPosition[corner] = vec4(centrePosition[corner], centreUv[corner].y);
    }
    cornerIds = uvec2(primitiveSeed[0], drawIndex[0]);
}
#else
VARYING(0) flat out vec2 cornerUv[3];
VARYING(3) flat out vec3 cornerAlpha;
VARYING(4) flat out uvec2 cornerIds;

void setCorners() {
    for (int corner = 0; corner < 3; ++corner)
        cornerUv[corner] = centreUv[corner];
    cornerAlpha = vec3(centreAlpha[0], centreAlpha[1], centreAlpha[2]);
    cornerIds = uvec2(primitiveSeed[0], drawIndex[0]);
}
#endif

void main() {
    uint count = agaa_beginPrimitive(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
    for (uint i = 0u; i < count; ++i) {
        setCorners();
        gl_PrimitiveID = gl_PrimitiveIDIn;
        agaa_setVertex(i);
        EmitVertex();
    }
}
