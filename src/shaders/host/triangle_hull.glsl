// For the host's geometry shader in passes that need a fragment for each pixel that a triangle touches. For each triangle
// it calls agaa_beginPrimitive(), then for each vertex of a strip agaa_setVertex() and EmitVertex(). pulled_hull.glsl is for
// vertex shaders.
#ifndef AGAA_HOST_TRIANGLE_HULL_GLSL
#define AGAA_HOST_TRIANGLE_HULL_GLSL
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
#if !AGAA_NEEDS_MATERIAL
    return corner;
#elif AGAA_CLIP_Z_FROM_MINUS_ONE
    return vec4(corner, 0.5 * (clip.z + clip.w));
#else
    return vec4(corner, clip.z);
#endif
}

// a, b, c: clip coordinates of the vertices, as the host's vertex shader gives them. Returns the number of vertices of the
// strip, 0 where there is nothing in front of the near plane. The strip faces as the triangle does.
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

// i: below what agaa_beginPrimitive() returned, in ascending order. Sets gl_Position and what the SDK's fragment shader
// text reads. The host's own outputs must be flat, or follow from agaa_cornerWeights() in its fragment shader.
void agaa_setVertex(uint i) {
    // A strip that turns the other way: neighbours change places, but for the first vertex and the last of an even number.
    uint other = (i & 1u) == 0u ? i - min(i, 1u) : i + 1u < agaa_hull.count ? i + 1u : i;
    gl_Position = agaa_hull.vertices[agaa_isHullMirrored ? other : i];
    agaa_corners = agaa_hullCorners;
}
#endif
