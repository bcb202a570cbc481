// Tells whether two samples of a G-buffer show one surface, by their normals and planes. Needs gbuffer/gbuffer.glsl.
#ifndef AGAA_SAME_SURFACE_GLSL
#define AGAA_SAME_SURFACE_GLSL
#include "common/sample_depth.glsl"

struct agaa_SurfacePoint {
    vec3 position; // in view space
    vec3 normal;   // in view space
};

// Reads a covered sample.
agaa_SurfacePoint agaa_surfacePoint(uvec2 pixel, uint i) {
    agaa_fetchSample(pixel, i);
    return agaa_SurfacePoint(agaa_sampleViewPosition(pixel, i, agaa_depthOf(pixel, i)),
                             mat3(agaa_frame.view) * agaa_fetchedNormal());
}

// Returns the difference of two points by that of the frame's thresholds: up to 1 they are of one surface. It grows up
// to 2e4 for normals that differ, and without bound for planes.
float agaa_surfaceDifference(agaa_SurfacePoint a, agaa_SurfacePoint b) {
    const vec3 between = b.position - a.position;
    const float plane = max(abs(dot(a.normal, between)), abs(dot(b.normal, between)));
    const float width = agaa_frame.surfaceDistance * agaa_pixelWidth(a.position.z);
    const float turn = (1.0 - dot(a.normal, b.normal)) / max(1.0 - agaa_frame.surfaceCosine, 1e-4);
    return max(turn, plane / max(width, 1e-30));
}
#endif
