// What a host's own shading pass reads of an aggregate.
#include "aggregate/stored_aggregate.glsl"

struct AgaaAggregate {
    uint samples;  // bit i: it holds sample i of the pixel; 0: there is no such aggregate
    vec3 diffuse;  // means over its samples
    vec3 specular; // reflectance at normal incidence
    vec3 emissive; // radiance
    vec3 normal;   // as long as normals agree
    float alpha2;  // of GGX, squared; of layouts that fold it into the normal's length, their spread included
    AGAA_CUSTOM_MEMBERS
};

// a: below AGAA_AGGREGATES.
AgaaAggregate agaaAggregate(uvec2 pixel, uint a) {
    agaa_selectAggregate(pixel, a);
    AgaaAggregate result;
    result.samples = agaa_coverage();
    agaa_aggregateSamples = max(uint(bitCount(result.samples)), 1u);
    agaa_Stored stored = agaa_storedMeans();
    agaa_Means m = agaa_meansOfStored(stored);
    result.diffuse = m.diffuse;
    result.specular = m.specular;
    result.emissive = m.emissive;
    result.normal = m.normal;
    result.alpha2 = AGAA_FOLDED_ROUGHNESS != 0u ? agaa_alpha2FromFoldedLength(length(m.normal)) : m.alpha2;
    AGAA_LOAD_CUSTOM(stored, result)
    return result;
}
