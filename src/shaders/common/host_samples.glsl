// Materials that functions of the host return, and samples of the host's G-buffer. Needs common/frame.glsl.
#ifndef AGAA_HOST_SAMPLES_GLSL
#define AGAA_HOST_SAMPLES_GLSL
#ifndef AGAA_FRAME_GLSL
#error "host_samples.glsl needs frame.glsl."
#endif
#include "common/curvature.glsl"
#include "common/scene_facts.glsl"
#if defined(AGAA_HOST_GBUFFER) || defined(AGAA_HOST_FETCH)
// Returns the values of members that the host does not set, which are those of agaa_surfaceInput().
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

uint agaa_demands = 0u; // of the current material, by agaa_applyFacts()

// Replaces the values that the facts of the scene fix.
// planeNormal   Normal of the primitive, on the side of the eye; the material's normal if it is not known.
// isExact       planeNormal is exact enough to compare the material's normal with it.
void agaa_applyFacts(inout AgaaMaterial m, vec3 planeNormal, bool isExact) {
    if (AGAA_CHECK_FACTS != 0u)
        agaa_demands = agaa_demandsOf(m.diffuse, m.specular, m.emissive, m.alpha2, agaa_frame.emissiveRange) |
                       (isExact ? agaa_demandOfNormal(m.normal, planeNormal) : 0u);
    m.normal = agaa_factNormal(m.normal, planeNormal);
    if (agaa_hasFact(AGAA_FACT_PLANE_NORMALS))
        m.normalDx = m.normalDy = vec3(0.0);
    m.diffuse = AGAA_DEBUG_VIEW == AGAA_DEBUG_VIEW_FACTS ? vec3(agaa_unmetDemands(agaa_demands) != 0u ? 1.0 : 0.0)
                                                         : agaa_factDiffuse(m.diffuse);
    m.specular = agaa_factSpecular3(m.specular);
    m.alpha2 = agaa_factAlpha2(m.alpha2);
}

// Replaces non-finite values by the lowest value of their range (hard case 37). Returns 1 if there was one.
uint agaa_sanitiseValues(inout AgaaMaterial m) {
    uint bad = 0u;
    m.diffuse = agaa_sanitise3(m.diffuse, 0.0, 1.0, bad);
    m.specular = agaa_sanitise3(m.specular, 0.0, 1.0, bad);
    m.emissive = agaa_sanitiseEmission(m.emissive, agaa_frame.emissiveRange, bad);
    m.normal = agaa_sanitiseNormal(m.normal, bad);
    m.alpha2 = agaa_sanitise(m.alpha2, agaa_minAlpha2(), 1.0, bad);
    AGAA_SANITISE_CUSTOM(m, bad)
    return bad | agaa_sanitiseNormalChange(m.normalDx, m.normalDy);
}

// Counts the demands of the material that was sanitised last.
void agaa_countFacts() {
#ifdef AGAA_COUNTERS_GLSL // the pass counts
    if (AGAA_CHECK_FACTS == 0u)
        return;
#define AGAA_COUNTER(index, name, member)
#define AGAA_COUNTER_MAX(index, name, member)
#define AGAA_COUNTER_FACT(index, name, member, fact) agaa_count(name, (agaa_demands & fact) == fact ? 1u : 0u);
#include "tables/counters.inc"
#undef AGAA_COUNTER
#undef AGAA_COUNTER_MAX
#undef AGAA_COUNTER_FACT
#endif
}
#endif
#ifdef AGAA_HOST_GBUFFER
bool agaa_readHost(uvec2 pixel, uint i, out float depth, out AgaaMaterial material) {
    depth = 0.0;
    material = agaa_defaultMaterial();
    if (!agaaHostSample(pixel, i, depth, material))
        return false;
    uint bad = agaa_sanitiseValues(material);
    agaa_applyFacts(material, material.normal, false);
    depth = agaa_sanitise(depth, 0.0, 1.0, bad);
    agaa_countFacts();
    return true;
}

bool agaa_hostShows(uvec2 pixel, uint i) {
    float depth;
    AgaaMaterial material;
    return agaa_readHost(pixel, i, depth, material);
}
#endif
#endif
