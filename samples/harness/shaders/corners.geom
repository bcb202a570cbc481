// Creates a fragment for each pixel that a triangle touches, with the material inputs of the three corners. The SDK's
// geometry text, interface.glsl and corner_outputs.glsl come before this text. corners.vert does the same.

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
#endif

void setCorners() {
    for (int i = 0; i < 3; ++i) {
        Corner corner;
        corner.uv = centreUv[i];
        corner.alpha = centreAlpha[i];
#if AGAA_NEEDS_MATERIAL
        corner.position = centrePosition[i];
        corner.normal = insideNormal[i];
        corner.tangent = insideTangent[i];
        corner.color = insideColor[i];
#endif
        setCorner(i, corner);
    }
    cornerIds = uvec3(primitiveSeed[0], drawIndex[0], gl_PrimitiveIDIn);
}

void main() {
    uint count = agaa_beginPrimitive(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_in[2].gl_Position);
    for (uint i = 0u; i < count; ++i) {
        setCorners();
        agaa_setVertex(i);
        EmitVertex();
    }
}
