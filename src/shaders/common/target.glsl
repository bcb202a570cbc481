// Access to the scaled, multisampled target by pixel and sample. Needs common/frame.glsl.
#ifndef AGAA_TARGET_GLSL
#define AGAA_TARGET_GLSL
#ifndef AGAA_FRAME_GLSL
#error "target.glsl needs frame.glsl."
#endif
#include "common/camera.glsl"
#include "math/depth.glsl"
#include "math/sanitise.glsl"
#include "common/host_code.glsl"

#ifndef AGAA_MULTISAMPLED // passes that read no target do not define it
#define AGAA_MULTISAMPLED 0
#endif
#if AGAA_MULTISAMPLED
#define AGAA_TARGET_TEXTURE sampler2DMS
#define AGAA_FETCH(image, pixel, i) texelFetch(image, agaaTexel(pixel, i), agaaTexelSample(i))
#else
#define AGAA_TARGET_TEXTURE sampler2D
#define AGAA_FETCH(image, pixel, i) texelFetch(image, agaaTexel(pixel, i), 0)
#endif

float agaa_sampleViewZ(float depth) {
    return agaa_viewZFromDepth(depth, agaa_frame.projection22, agaa_frame.projection32,
                               agaa_isOrthographic());
}

// Returns the step of the depth buffer at this depth.
float agaa_storedQuantum(float depth) {
    float quantum = agaa_frame.depthQuantum;
    return quantum < 0.0 ? -quantum * depth : quantum;
}

// offset   Position in the pixel, [0, 1].
vec3 agaa_viewPositionAtZ(uvec2 pixel, vec2 offset, float z) {
    vec2 ndc = (vec2(pixel) + offset) / vec2(agaa_frame.size) * 2.0 - 1.0;
    return agaa_viewPosition(ndc, z, agaa_frame.projectionScale.x, agaa_frame.projectionScale.y,
                             agaa_frame.projectionOffset.x, agaa_frame.projectionOffset.y, agaa_isOrthographic());
}

vec3 agaa_viewPositionAt(uvec2 pixel, vec2 offset, float depth) {
    return agaa_viewPositionAtZ(pixel, offset, agaa_sampleViewZ(depth));
}

vec3 agaa_sampleViewPosition(uvec2 pixel, uint i, float depth) {
    return agaa_viewPositionAt(pixel, agaa_sampleLocation(i), depth);
}
#endif
