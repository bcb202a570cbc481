// Conversion of depth planes of triangles to those of surfaces, whose depths increase away from the eye. Needs
// AGAA_FAR_DEPTH, which common/constants.glsl has.
#ifndef AGAA_GROWING_DEPTH_GLSL
#define AGAA_GROWING_DEPTH_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && !defined(AGAA_FAR_DEPTH)
#error "growing_depth.glsl needs AGAA_FAR_DEPTH."
#endif
#include "math/depth_plane.glsl"

// Returns whether the plane is at the far plane, which is background.
bool agaa_isAtFarDepth(agaa_DepthPlane plane) {
    return AGAA_FAR_DEPTH != 0u ? plane.range.x >= 1.0 : plane.range.y <= 0.0;
}

// Returns depth and slopes with depths that increase away from the eye.
vec3 agaa_growingDepth(agaa_DepthPlane plane) { return agaa_planeInRange(plane) * (AGAA_FAR_DEPTH != 0u ? 1.0 : -1.0); }
#endif
