// The depth of a sample as stored in the depth buffer. Needs common/target.glsl.
#ifndef AGAA_SAMPLE_DEPTH_GLSL
#define AGAA_SAMPLE_DEPTH_GLSL
#ifndef AGAA_TARGET_GLSL
#error "sample_depth.glsl needs target.glsl."
#endif
#include "common/host_samples.glsl"
#ifdef AGAA_HOST_GBUFFER
float agaa_depthOf(uvec2 pixel, uint i) {
    float depth;
    AgaaMaterial material;
    agaa_readHost(pixel, i, depth, material);
    return depth;
}
#elif defined(AGAA_EXPANDED) && AGAA_EXPANDED
#include "ids/visible_samples.glsl"
float agaa_depthOf(uvec2 pixel, uint i) { return agaa_visibleDepth(pixel, i); }
#else
layout(AGAA_BINDING_DEPTH) uniform AGAA_TARGET_TEXTURE agaa_depth;

float agaa_depthOf(uvec2 pixel, uint i) { return AGAA_FETCH(agaa_depth, pixel, i).x; }
#endif
#endif
