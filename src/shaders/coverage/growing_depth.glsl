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

// Returns the plane with depths that increase away from the eye.
agaa_DepthPlane agaa_growingDepth(agaa_DepthPlane plane) {
    if (AGAA_FAR_DEPTH != 0u)
        return plane;
    return agaa_DepthPlane(-plane.depth, -plane.slope, -plane.range.yx);
}
#endif
