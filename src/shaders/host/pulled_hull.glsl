// Triangle hulls for the host's vertex shader, in passes with AgaaDrawState::vertexPulling. The vertex shader fetches
// the three vertices of a triangle and calls agaa_pullVertex() once. A draw has AGAA_MAX_STRIP vertices for each
// triangle.
#ifndef AGAA_HOST_PULLED_HULL_GLSL
#define AGAA_HOST_PULLED_HULL_GLSL
#include "host/triangle_hull.glsl"

// Sets gl_Position and the inputs of the SDK's fragment shader text. A strip with fewer vertices repeats its last one.
// An invisible triangle has all vertices at one position. Neither draws additional fragments. The host's outputs must
// be flat, or its fragment shader must derive them from agaa_cornerWeights().
// a, b, c   Clip coordinates of the triangle's vertices.
// vertex    Vertex of the strip, [0, AGAA_MAX_STRIP).
void agaa_pullVertex(vec4 a, vec4 b, vec4 c, uint vertex) {
    uint count = agaa_beginPrimitive(a, b, c);
    agaa_setVertex(min(vertex, max(count, 1u) - 1u));
}
#endif
