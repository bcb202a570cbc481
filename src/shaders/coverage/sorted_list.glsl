// Sorted fragment lists, with the primitives of fragments. Needs what ids/fetch.glsl and
// coverage/fragment_words.glsl need.
#ifndef AGAA_SORTED_LIST_GLSL
#define AGAA_SORTED_LIST_GLSL
#include "common/curvature.glsl"
#include "ids/fetch.glsl"
#include "coverage/fragment_words.glsl"
#include "coverage/growing_depth.glsl"
#include "coverage/list_order.glsl"

agaa_DepthPlane agaa_planeOf(AgaaPrimitive p, uvec2 pixel) {
    vec2 pixelsPerNdc = 0.5 * vec2(agaa_frame.size);
    vec3 z = vec3(p.a.z, p.b.z, p.c.z);
#if AGAA_CLIP_Z_FROM_MINUS_ONE
    z = 0.5 * (z + vec3(p.a.w, p.b.w, p.c.w));
#endif
    return agaa_depthPlane(agaa_vertexInPixels(p.a.xyw, pixelsPerNdc), agaa_vertexInPixels(p.b.xyw, pixelsPerNdc),
                           agaa_vertexInPixels(p.c.xyw, pixelsPerNdc), z, vec2(pixel) + 0.5);
}

void agaa_widenByCurvature(inout AgaaMaterial m, uvec4 mask) {
    m.alpha2 = agaa_widenedByCurvature(m.alpha2, m.normalDx, m.normalDy, mask);
}
#endif
