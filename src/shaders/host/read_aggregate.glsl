// Reads aggregates in a host's shading pass.
#include "aggregate/stored_aggregate.glsl"

struct AgaaAggregate {
    uint samples;  // bit i: it contains sample i of the pixel; 0: the pixel has no such aggregate
    vec3 diffuse;  // means over its samples
    vec3 specular; // reflectance at normal incidence
    vec3 emissive; // radiance
    vec3 normal;   // its length is 1 if all normals agree
    float alpha2;  // GGX alpha squared; layouts that fold it into the normal's length include the spread of normals
    // Second moments of the unit normals, if AgaaConfig::ndf is LEAN or SGGX and the view has specular light. Otherwise
    // they are 0.
    vec3 normalSquares;  // xx, yy, zz
    vec3 normalProducts; // yz, zx, xy
    AGAA_CUSTOM_MEMBERS
};

// a   Index of the aggregate, [0, AGAA_AGGREGATES).
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
    if (AGAA_SPREAD_WORDS != 0u && result.samples != 0u)
        m.moments = agaa_storedMoments();
    result.normalSquares = m.moments.squares;
    result.normalProducts = m.moments.mixed;
    AGAA_LOAD_CUSTOM(stored, result)
    return result;
}
