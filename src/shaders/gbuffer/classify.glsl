// Which pixels show more than one surface, so that each of their samples is shaded (Lauritzen 2010). Of one
// surface are samples whose normals, planes and materials differ by no more than the frame's thresholds.
#ifndef AGAA_CLASSIFY_GLSL
#define AGAA_CLASSIFY_GLSL
#include "gbuffer/gbuffer.glsl"
#include "common/sample_depth.glsl"

float agaa_largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

float agaa_materialDifference(agaa_Surface a, agaa_Surface b) {
    float d = agaa_largest(abs(a.diffuse - b.diffuse));
    if (AGAA_HAS_SPECULAR != 0u)
        d = max(d, max(agaa_largest(abs(a.specular - b.specular)), abs(a.alpha2 - b.alpha2)));
    if (AGAA_EMISSIVE_CHANNELS != 0u)
        d = max(d, agaa_largest(abs(a.emissive - b.emissive)) / agaa_frame.ambient.w);
    return d;
}

// mask: of the samples that show geometry, of which there is one.
bool agaa_isComplex(uvec2 pixel, uint mask) {
    uint i = uint(findLSB(mask));
    agaa_fetchSample(pixel, i);
    agaa_Surface first = agaa_sampleSurface();
    first.normal = mat3(agaa_frame.view) * first.normal;
    vec3 at = agaa_sampleViewPosition(pixel, i, agaa_depthOf(pixel, i));
    float farthest = agaa_frame.surface.y * agaa_pixelWidth(at.z); // from the plane of the first sample
    bool complex = false;
    for (uint rest = mask & (mask - 1u); rest != 0u && !complex; rest &= rest - 1u) {
        i = uint(findLSB(rest));
        agaa_fetchSample(pixel, i);
        agaa_Surface s = agaa_sampleSurface();
        s.normal = mat3(agaa_frame.view) * s.normal;
        vec3 p = agaa_sampleViewPosition(pixel, i, agaa_depthOf(pixel, i));
        complex = dot(first.normal, s.normal) < agaa_frame.surface.x ||
                  abs(dot(first.normal, p - at)) > farthest ||
                  agaa_materialDifference(first, s) > agaa_frame.surface.z;
    }
    return complex;
}
#endif
