// Depth planes of triangles as surfaces keep them.
#ifndef AGAA_GROWING_DEPTH_GLSL
#define AGAA_GROWING_DEPTH_GLSL
#include "math/depth_plane.glsl"

// What is at the far plane is background.
bool agaa_isAtFarDepth(agaa_DepthPlane plane) { return AGAA_FAR_DEPTH != 0u ? plane.range.x >= 1.0 : plane.range.y <= 0.0; }

// The plane as it is kept, with depths that grow away from the eye.
vec3 agaa_growingDepth(agaa_DepthPlane plane) { return agaa_planeInRange(plane) * (AGAA_FAR_DEPTH != 0u ? 1.0 : -1.0); }
#endif
