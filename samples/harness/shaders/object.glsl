// Positions of vertices, which all vertex shaders of the draw passes compute identically. interface.glsl comes before
// this text.

layout(std140, CAMERA_AT) uniform Camera {
    mat4 viewProjection;
    vec4 viewer; // homogeneous position in shading space
    float footprint; // width of the textures' footprint, as a share of the pixel
    float unitDistance; // of images of motion
    vec2 jitter; // by which the projection moves the image, in clip space
} camera;

DRAW_BLOCK Draw {
    vec4 toShading[3];       // rows of object to shading space
    vec4 normalToShading[3]; // rows of the inverse transpose
    uint seed;
    float handedness; // -1 if the transform mirrors
    uint index;       // index in the frame's list of draws
    uint firstIndex;  // first index of the mesh
    uint firstVertex;
} draw;

// The sums have an explicit order and are precise. Compilers may choose the order of dot() and of matrix products and
// contract sums, and rounding would decide which of two surfaces at equal depth shows. `invariant gl_Position` does not
// cover the vertex shader that pulls, and a caller's `precise` does not cover functions.
float transformRow(vec4 row, vec3 p) {
    precise float sum = ((row.x * p.x + row.y * p.y) + row.z * p.z) + row.w;
    return sum;
}

vec3 transform(vec4 rows[3], vec3 p) {
    return vec3(transformRow(rows[0], p), transformRow(rows[1], p), transformRow(rows[2], p));
}

vec3 rotate(vec4 rows[3], vec3 v) {
    return vec3(dot(rows[0].xyz, v), dot(rows[1].xyz, v), dot(rows[2].xyz, v));
}

vec4 clipOf(vec3 position) {
    mat4 m = camera.viewProjection;
    precise vec4 clip = ((m[0] * position.x + m[1] * position.y) + m[2] * position.z) + m[3];
    return clip;
}

// vertex is the index of the primitive's first corner, including the first vertex of the mesh.
uint seedOf(uint vertex) {
    uint seed = (draw.seed ^ vertex) * 0x9E3779B1u;
    return seed ^ (seed >> 15);
}
