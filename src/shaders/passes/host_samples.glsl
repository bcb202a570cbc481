// Samples of a G-buffer that a function of the host's reads.
#ifndef AGAA_HOST_SAMPLES_GLSL
#define AGAA_HOST_SAMPLES_GLSL
#include "math/ndf.glsl"
#ifdef AGAA_HOST_GBUFFER
// What the function leaves alone is as in agaa_surfaceInput(); what is not finite becomes 0 (hard case 37).
bool agaa_readHost(uvec2 pixel, uint i, out AgaaSample s) {
    s = AgaaSample(0.0, vec3(0.5), vec3(0.04), vec3(0.0), vec3(0.0, 0.0, 1.0), 1.0);
    if (!agaaHostSample(pixel, i, s))
        return false;
    uint bad = 0u;
    s.depth = agaa_sanitise(s.depth, 0.0, 1.0, bad);
    s.diffuse = agaa_sanitise3(s.diffuse, 0.0, 1.0, bad);
    s.specular = agaa_sanitise3(s.specular, 0.0, 1.0, bad);
    s.emissive = agaa_sanitise3(s.emissive, 0.0, agaa_frame.ambient.w, bad);
    s.normal = agaa_sanitise3(s.normal, -1.0, 1.0, bad);
    float l2 = dot(s.normal, s.normal);
    s.normal = l2 > 1e-12 ? s.normal * inversesqrt(l2) : vec3(0.0, 0.0, 1.0);
    s.alpha2 = agaa_sanitise(s.alpha2, agaa_minAlpha2(), 1.0, bad);
    return true;
}
#endif
#endif
