// The sample engine's one vertex shader for all passes that must agree on depth. The version and
// interface.glsl come before this text.

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
// Read inside the primitive; see material.frag for why these are not the same.
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

layout(std140, CAMERA_AT) uniform Camera { mat4 viewProjection; float footprint; } camera;

DRAW_BLOCK Draw {
    vec4 toShading[3];       // rows of object to shading space
    vec4 normalToShading[3]; // rows of the inverse transpose
    uint seed;
    float handedness; // -1 where the transform mirrors
    uint index;       // in the frame's list
} draw;

invariant gl_Position;

float transformRow(vec4 row, vec3 p) { return ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w; }

vec3 transform(vec4 rows[3], vec3 p) {
    return vec3(transformRow(rows[0], p), transformRow(rows[1], p), transformRow(rows[2], p));
}

vec3 rotate(vec4 rows[3], vec3 v) {
    return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v));
}

void main() {
    // Sums in an order of their own: compilers are free to choose that of dot() and of matrix products, and of
    // surfaces at equal depth rounding picks the one that shows.
    vec3 position = transform(draw.toShading, vertexPosition);
    mat4 m = camera.viewProjection;
    gl_Position = ((m[0] * position.x + m[1] * position.y) + m[2] * position.z) + m[3];
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
    // Of the primitive's first vertex.
    uint seed = (draw.seed ^ uint(VERTEX_INDEX)) * 0x9E3779B1u;
    primitiveSeed = seed ^ (seed >> 15);
    drawIndex = draw.index;
}
