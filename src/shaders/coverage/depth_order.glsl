// The depth by which the fragments of a list are sorted. Needs AGAA_SAMPLES and what growing_depth.glsl needs.
#ifndef AGAA_DEPTH_ORDER_GLSL
#define AGAA_DEPTH_ORDER_GLSL
#include "math/ordered_bits.glsl"
#include "coverage/growing_depth.glsl"
#include "math/coverage_pattern.glsl"

// Returns a number that increases with the distance of the covered samples' centroid (coverage/fragment_layout.glsl).
uint agaa_depthOrder(agaa_DepthPlane plane, uvec4 mask) {
    return agaa_orderedBits(agaa_depthAt(agaa_growingDepth(plane), agaa_coverageMiddle(mask, AGAA_SAMPLES)));
}
#endif
