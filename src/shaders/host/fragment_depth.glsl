// Depths of fragments in passes that have the corners of triangles.
#ifndef AGAA_HOST_FRAGMENT_DEPTH_GLSL
#define AGAA_HOST_FRAGMENT_DEPTH_GLSL
#include "host/fragment_coverage.glsl"
#include "coverage/depth_order.glsl"

// Returns the depth plane of the triangle in the pixel.
agaa_DepthPlane agaa_cornerPlane() {
    return agaa_depthPlane(agaa_corners[0].xyz, agaa_corners[1].xyz, agaa_corners[2].xyz,
                           vec3(agaa_corners[0].w, agaa_corners[1].w, agaa_corners[2].w), gl_FragCoord.xy);
}
#endif
