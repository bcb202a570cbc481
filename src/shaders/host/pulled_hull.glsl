// For the host's vertex shader in passes with AgaaDrawState::vertexPulling. It fetches the three vertices of a triangle itself
// and calls agaa_pullVertex() once. A draw has AGAA_MAX_STRIP vertices for each triangle.
#ifndef AGAA_HOST_PULLED_HULL_GLSL
#define AGAA_HOST_PULLED_HULL_GLSL
#include "host/triangle_hull.glsl"

// a, b, c: clip coordinates of the triangle's vertices. vertex: in [0, AGAA_MAX_STRIP), of the strip that is drawn. Sets
// gl_Position and what the SDK's fragment shader text reads. A strip with fewer vertices repeats its last one, and a triangle
// that is not visible has all vertices at one place: neither draws anything. The host's own outputs must be flat, or follow
// from agaa_cornerWeights() in its fragment shader.
void agaa_pullVertex(vec4 a, vec4 b, vec4 c, uint vertex) {
    uint count = agaa_beginPrimitive(a, b, c);
    agaa_setVertex(min(vertex, max(count, 1u) - 1u));
}
#endif
