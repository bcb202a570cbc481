// The samples of a pixel that a triangle covers: exact, or with AGAA_COVERS_BY_TABLE from a table for sample positions
// of the host. With AGAA_COVERS_TARGET the samples are those of the target. Needs AGAA_SAMPLES and AGAA_TABLE_SIZE.
// Source: Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, section 3.1.
#ifndef AGAA_COVERED_SAMPLES_GLSL
#define AGAA_COVERED_SAMPLES_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && (!defined(AGAA_SAMPLES) || !defined(AGAA_TABLE_SIZE))
#error "covered_samples.glsl needs AGAA_SAMPLES and AGAA_TABLE_SIZE."
#endif
#ifndef AGAA_COVERS_TARGET
#define AGAA_COVERS_TARGET 0
#endif
#include "math/triangle_coverage.glsl"
#if AGAA_COVERS_BY_TABLE
#include "math/coverage_table.glsl"
layout(AGAA_BINDING_COVERAGE_TABLE) uniform usampler2D agaa_coverageTable;

uvec4 agaa_edgeByTable(vec3 a, vec3 b) {
    agaa_CoverageLookup found = agaa_findCoverage(a, b, AGAA_TABLE_SIZE);
    uvec2 texel = agaa_tableTexel(found.entry, AGAA_TABLE_SIZE);
    uvec4 mask = texel.y < AGAA_TABLE_SIZE ? texelFetch(agaa_coverageTable, ivec2(texel), 0) : uvec4(0u);
    return agaa_foundCoverage(found, mask, AGAA_SAMPLES);
}
#endif

#if AGAA_COVERS_TARGET
// Returns the samples that each of three edges covers.
uvec3 agaa_targetSamples(agaa_Edge x, agaa_Edge y, agaa_Edge z) {
    uvec3 mask = uvec3(0u);
    for (uint i = 0u; i < AGAA_SAMPLES; ++i) {
        vec2 at = agaa_sampleLocation(i) - 0.5;
        mask.x |= agaa_edgeCovers(x, at) ? 1u << i : 0u;
        mask.y |= agaa_edgeCovers(y, at) ? 1u << i : 0u;
        mask.z |= agaa_edgeCovers(z, at) ? 1u << i : 0u;
    }
    return mask;
}
#endif

// a, b, c   Vertices of agaa_triangleCoverage().
// centre    Of the pixel, in pixels.
uvec4 agaa_coveredSamples(vec3 a, vec3 b, vec3 c, vec2 centre) {
#if AGAA_COVERS_TARGET
    a = agaa_vertexFromCentre(a, centre);
    b = agaa_vertexFromCentre(b, centre);
    c = agaa_vertexFromCentre(c, centre);
    uvec3 mask = agaa_targetSamples(agaa_edgeFromCentre(b, c), agaa_edgeFromCentre(c, a), agaa_edgeFromCentre(a, b));
    return agaa_joinEdges(a, b, c, uvec4(mask.x, 0u, 0u, 0u), uvec4(mask.y, 0u, 0u, 0u), uvec4(mask.z, 0u, 0u, 0u),
                          AGAA_SAMPLES);
#elif AGAA_COVERS_BY_TABLE
    a = agaa_vertexFromCentre(a, centre);
    b = agaa_vertexFromCentre(b, centre);
    c = agaa_vertexFromCentre(c, centre);
    return agaa_joinEdges(a, b, c, agaa_edgeByTable(b, c), agaa_edgeByTable(c, a), agaa_edgeByTable(a, b),
                          AGAA_SAMPLES);
#else
    return agaa_triangleCoverage(a, b, c, centre, AGAA_SAMPLES);
#endif
}
#endif
