// The sample engine's vertex shader for all passes that must agree on depth. The version, interface.glsl and
// object.glsl come before this text.

LOCATION(0) in vec3 vertexPosition;
LOCATION(1) in vec3 vertexNormal;
LOCATION(2) in vec4 vertexTangent;
LOCATION(3) in vec2 vertexUv;
LOCATION(4) in vec4 vertexColor;

// Outputs: 0 all, 1 those that corners.geom reads for coverage, 2 those that it reads for materials.
#ifndef FOR_CORNERS
#define FOR_CORNERS 0
#endif

// Read at the pixel's centre. Positions and vectors are in shading space.
#if FOR_CORNERS != 1
VARYING(0) out vec3 centrePosition;
#endif
VARYING(1) out vec2 centreUv;
VARYING(2) out float centreAlpha;
// Read inside the primitive. material.frag explains why these inputs are separate.
#if FOR_CORNERS == 0
VARYING(3) out vec4 insidePosition; // w: 1
VARYING(6) out vec2 insideUv;
#endif
#if FOR_CORNERS != 1
VARYING(4) out vec3 insideNormal;
VARYING(5) out vec4 insideTangent;
VARYING(7) out vec3 insideColor;
#endif
VARYING(8) flat out uint primitiveSeed;
VARYING(9) flat out uint drawIndex;

invariant gl_Position;

void main() {
    vec3 position = transform(draw.toShading, vertexPosition);
    gl_Position = clipOf(position);
#ifdef MULTICAST
    agaa_multicast();
#endif
    centreUv = vertexUv;
    centreAlpha = vertexColor.a;

#if FOR_CORNERS == 0
    insidePosition = vec4(position, 1.0);
    insideUv = vertexUv;
#endif
#if FOR_CORNERS != 1
    centrePosition = position;
    insideNormal = rotate(draw.normalToShading, vertexNormal);
    insideTangent = vec4(rotate(draw.toShading, vertexTangent.xyz),
                            vertexTangent.w * draw.handedness);
    insideColor = vertexColor.rgb;
#endif
    primitiveSeed = seedOf(uint(VERTEX_INDEX)); // from the first vertex of the primitive
    drawIndex = draw.index;
}
