// Triangle hulls for the host's geometry shader, in passes that need a fragment for each pixel that a triangle touches.
// For each triangle, the shader calls agaa_beginPrimitive(), then agaa_setVertex() and EmitVertex() for each vertex of
// the strip. pulled_hull.glsl is for vertex shaders. Needs AGAA_CLIP_Z_FROM_MINUS_ONE and AGAA_FAR_DEPTH.
#ifndef AGAA_HOST_TRIANGLE_HULL_GLSL
#define AGAA_HOST_TRIANGLE_HULL_GLSL
#if !defined(AGAA_CLIP_Z_FROM_MINUS_ONE) || !defined(AGAA_FAR_DEPTH)
#error "triangle_hull.glsl needs AGAA_CLIP_Z_FROM_MINUS_ONE and AGAA_FAR_DEPTH."
#endif
#include "host/corners.glsl"
#include "math/triangle_coverage.glsl"
#include "math/triangle_hull.glsl"

#define AGAA_MAX_STRIP 8 // of layout(triangle_strip, max_vertices = AGAA_MAX_STRIP) out

AGAA_AT_CORNERS flat out AGAA_CORNER agaa_corners[3];

agaa_Hull agaa_hull;
AGAA_CORNER agaa_hullCorners[3];
bool agaa_isHullMirrored;

AGAA_CORNER agaa_cornerOf(vec4 clip, vec2 pixelsPerNdc) {
    vec3 corner = agaa_vertexInPixels(clip.xyw, pixelsPerNdc);
#if AGAA_CLIP_Z_FROM_MINUS_ONE
    return vec4(corner, 0.5 * (clip.z + clip.w));
#else
    return vec4(corner, clip.z);
#endif
}

// Returns the number of vertices of the strip, 0 if nothing is in front of the near plane. The strip has the triangle's
// facing.
// a, b, c   Clip coordinates of the vertices, as the host's vertex shader outputs them.
uint agaa_beginPrimitive(vec4 a, vec4 b, vec4 c) {
    vec2 pixelsPerNdc = 0.5 * vec2(agaa_frame.size);
#if AGAA_FAR_DEPTH == 0
    vec2 nearPlane = vec2(-1.0, 1.0);
#elif AGAA_CLIP_Z_FROM_MINUS_ONE
    vec2 nearPlane = vec2(1.0, 1.0);
#else
    vec2 nearPlane = vec2(1.0, 0.0);
#endif
    agaa_hull = agaa_triangleHull(a, b, c, nearPlane, pixelsPerNdc);
    agaa_hullCorners[0] = agaa_cornerOf(a, pixelsPerNdc);
    agaa_hullCorners[1] = agaa_cornerOf(b, pixelsPerNdc);
    agaa_hullCorners[2] = agaa_cornerOf(c, pixelsPerNdc);
    agaa_isHullMirrored = agaa_facing(a.xyw, b.xyw, c.xyw) < 0.0;
    return agaa_hull.count;
}

// Sets gl_Position and the inputs of the SDK's fragment shader text. The host's outputs must be flat, or its fragment
// shader must derive them from agaa_cornerWeights().
// i   Vertex of the strip, in ascending order, below the number that agaa_beginPrimitive() returned.
void agaa_setVertex(uint i) {
    // A mirrored strip swaps neighbours, except the first vertex and the last of an even number.
    uint other = (i & 1u) == 0u ? i - min(i, 1u) : i + 1u < agaa_hull.count ? i + 1u : i;
    gl_Position = agaa_hull.vertices[agaa_isHullMirrored ? other : i];
    agaa_corners = agaa_hullCorners;
}
#endif
