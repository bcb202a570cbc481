// The facts of a scene about its materials (AgaaSceneFacts), for shaders of hosts and for passes.
#ifndef AGAA_SCENE_FACTS_GLSL
#define AGAA_SCENE_FACTS_GLSL
#include "common/api_values.glsl"
#include "math/material_facts.glsl"

bool agaa_hasFact(uint fact) { return (AGAA_FACTS & fact) != 0u; }

bool agaa_isCutout(float cutoff) {
    return agaa_isCutoutByFacts(cutoff, agaa_hasFact(AGAA_FACT_NO_TRANSLUCENCY), agaa_hasFact(AGAA_FACT_NO_CUTOUTS));
}

// Returns the bits of the facts that this material demands or contradicts. emissiveRange: of the layout.
uint agaa_demandsOf(vec3 diffuse, vec3 specular, vec3 emissive, float alpha2, float emissiveRange) {
    const float least = 2e-3; // above the rounding of 8 bits
    vec3 apart = abs(specular - specular.yzx);
    vec3 other = abs(specular - uintBitsToFloat(AGAA_ONE_SPECULAR));
    uint demands = 0u;
    demands |= max(specular.x, max(specular.y, specular.z)) > least ? AGAA_FACT_SPECULAR : 0u;
    demands |= agaa_isEmissive(emissive, emissiveRange) ? AGAA_FACT_EMISSIVE : 0u;
    demands |= abs(sqrt(alpha2) - sqrt(uintBitsToFloat(AGAA_ONE_ALPHA2))) > least ? AGAA_FACT_ONE_ROUGHNESS : 0u;
    demands |= max(apart.x, max(apart.y, apart.z)) > least ? AGAA_FACT_GREY_SPECULAR : 0u;
    demands |= max(other.x, max(other.y, other.z)) > least ? AGAA_FACT_ONE_SPECULAR : 0u;
    demands |= max(diffuse.x, max(diffuse.y, diffuse.z)) > least ? AGAA_FACT_NO_DIFFUSE : 0u;
    return demands;
}

uint agaa_demandOfNormal(vec3 normal, vec3 planeNormal) {
    const float least = 0.9998; // below the rounding of codes of 8 bits
    return dot(normal, planeNormal) < least ? AGAA_FACT_PLANE_NORMALS : 0u;
}

// Returns the demands that the facts of the view do not meet.
uint agaa_unmetDemands(uint demands) {
    const uint wanted = AGAA_FACT_SPECULAR | AGAA_FACT_EMISSIVE | AGAA_FACT_ALPHA_MASKED;
    uint unmet = demands & (AGAA_FACTS ^ wanted);
    // Without specular shading, roughness and colour of the reflectance do not matter.
    return agaa_hasFact(AGAA_FACT_SPECULAR)
               ? unmet
               : unmet & ~(AGAA_FACT_ONE_ROUGHNESS | AGAA_FACT_GREY_SPECULAR | AGAA_FACT_ONE_SPECULAR);
}

// The following functions return the value that the facts fix, or the material's value.
vec3 agaa_factDiffuse(vec3 diffuse) { return agaa_hasFact(AGAA_FACT_NO_DIFFUSE) ? vec3(0.0) : diffuse; }

vec3 agaa_factSpecular3(vec3 specular) {
    if (agaa_hasFact(AGAA_FACT_ONE_SPECULAR))
        return vec3(uintBitsToFloat(AGAA_ONE_SPECULAR));
    return agaa_hasFact(AGAA_FACT_GREY_SPECULAR) ? vec3((specular.x + specular.y + specular.z) / 3.0) : specular;
}

// Returns the reflectance from the channels that a layout stores: none, one or three.
vec3 agaa_storedSpecular(vec3 specular) {
    return agaa_hasFact(AGAA_FACT_GREY_SPECULAR) && !agaa_hasFact(AGAA_FACT_ONE_SPECULAR) ? specular.xxx
                                                                                      : agaa_factSpecular3(specular);
}

vec3 agaa_factNormal(vec3 normal, vec3 planeNormal) {
    return agaa_hasFact(AGAA_FACT_PLANE_NORMALS) ? planeNormal : normal;
}

float agaa_factAlpha2(float alpha2) {
    return agaa_hasFact(AGAA_FACT_ONE_ROUGHNESS) ? uintBitsToFloat(AGAA_ONE_ALPHA2) : alpha2;
}
#endif
