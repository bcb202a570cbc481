// The samples of a pixel that a triangle covers: exact, or with AGAA_COVERS_BY_TABLE from a table for sample positions
// of the host. Needs AGAA_SAMPLES and AGAA_TABLE_SIZE.
// Source: Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, section 3.1.
#ifndef AGAA_COVERED_SAMPLES_GLSL
#define AGAA_COVERED_SAMPLES_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && (!defined(AGAA_SAMPLES) || !defined(AGAA_TABLE_SIZE))
#error "covered_samples.glsl needs AGAA_SAMPLES and AGAA_TABLE_SIZE."
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

// a, b, c   Vertices of agaa_triangleCoverage().
// centre    Of the pixel, in pixels.
uvec4 agaa_coveredSamples(vec3 a, vec3 b, vec3 c, vec2 centre) {
#if AGAA_COVERS_BY_TABLE
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
