// Materials that functions of the host's give, and samples of a G-buffer of its own.
#ifndef AGAA_HOST_SAMPLES_GLSL
#define AGAA_HOST_SAMPLES_GLSL
#include "passes/curvature.glsl"
#if defined(AGAA_HOST_GBUFFER) || defined(AGAA_HOST_FETCH)
// What functions leave alone; as in agaa_surfaceInput().
AgaaMaterial agaa_defaultMaterial() {
    AgaaMaterial m;
    m.diffuse = vec3(0.5);
    m.specular = vec3(0.04);
    m.emissive = vec3(0.0);
    m.normal = vec3(0.0, 0.0, 1.0);
    m.alpha2 = 1.0;
    m.normalDx = m.normalDy = vec3(0.0);
    AGAA_CLEAR_CUSTOM(m)
    return m;
}

// What is not finite becomes the least of its range (hard case 37). Returns 1 where something was not.
uint agaa_sanitiseMaterial(inout AgaaMaterial m) {
    uint bad = 0u;
    m.diffuse = agaa_sanitise3(m.diffuse, 0.0, 1.0, bad);
    m.specular = agaa_sanitise3(m.specular, 0.0, 1.0, bad);
    m.emissive = agaa_sanitiseEmission(m.emissive, agaa_frame.ambient.w, bad);
    m.normal = agaa_sanitiseNormal(m.normal, bad);
    m.alpha2 = agaa_sanitise(m.alpha2, agaa_minAlpha2(), 1.0, bad);
    AGAA_SANITISE_CUSTOM(m, bad)
    bad |= agaa_sanitiseNormalChange(m.normalDx, m.normalDy);
    return bad;
}
#endif
#ifdef AGAA_HOST_GBUFFER
bool agaa_readHost(uvec2 pixel, uint i, out float depth, out AgaaMaterial material) {
    depth = 0.0;
    material = agaa_defaultMaterial();
    if (!agaaHostSample(pixel, i, depth, material))
        return false;
    uint bad = agaa_sanitiseMaterial(material);
    depth = agaa_sanitise(depth, 0.0, 1.0, bad);
    return true;
}

bool agaa_hostShows(uvec2 pixel, uint i) {
    float depth;
    AgaaMaterial material;
    return agaa_readHost(pixel, i, depth, material);
}
#endif
#endif
