// Which pixels show more than one surface, so that each of their samples is shaded (Lauritzen 2010). Of one
// surface are samples whose normals, planes and materials differ by no more than the frame's thresholds.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/gbuffer.glsl"
#include "passes/sample_depth.glsl"

layout(AGAA_AT_METADATA_OUT) writeonly uniform uimage2D agaa_classes;

float agaa_largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

float agaa_materialDifference(agaa_Surface a, agaa_Surface b) {
    float d = agaa_largest(abs(a.diffuse - b.diffuse));
    if (AGAA_HAS_SPECULAR != 0u)
        d = max(d, max(agaa_largest(abs(a.specular - b.specular)), abs(a.alpha2 - b.alpha2)));
    if (AGAA_EMISSIVE_CHANNELS != 0u)
        d = max(d, agaa_largest(abs(a.emissive - b.emissive)) / agaa_frame.ambient.w);
    return d;
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, agaa_frame.size.xy)))
        return;
    agaa_Surface first;
    vec3 at = vec3(0.0);
    float width = 0.0; // farthest that a surface may be from the plane of the first sample
    bool isFirst = true;
    bool complex = false;
    for (uint i = 0u; i < AGAA_SAMPLES && !complex; ++i) {
        if (!agaa_fetchSample(pixel, i))
            continue;
        agaa_Surface s = agaa_sampleSurface();
        vec3 p = agaa_sampleViewPosition(pixel, i, agaa_depthOf(pixel, i));
        if (isFirst) {
            first = s;
            first.normal = mat3(agaa_frame.view) * s.normal;
            at = p;
            width = agaa_frame.surface.y * agaa_pixelWidth(p.z);
            isFirst = false;
            continue;
        }
        s.normal = mat3(agaa_frame.view) * s.normal;
        complex = dot(first.normal, s.normal) < agaa_frame.surface.x ||
                  abs(dot(first.normal, p - at)) > width ||
                  agaa_materialDifference(first, s) > agaa_frame.surface.z;
    }
    imageStore(agaa_classes, ivec2(pixel), uvec4(complex ? 1u : 0u));
}
