// The samples of a pixel that a fragment covers, in passes that draw a fragment for each pixel that a triangle touches.
// Needs AGAA_TABLE_SIZE.
// Source: Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, section 3.1.
#ifndef AGAA_HOST_FRAGMENT_COVERAGE_GLSL
#define AGAA_HOST_FRAGMENT_COVERAGE_GLSL
#ifndef AGAA_TABLE_SIZE
#error "fragment_coverage.glsl needs AGAA_TABLE_SIZE."
#endif
#include "host/corners.glsl"
#include "math/barycentrics.glsl"
#include "math/triangle_coverage.glsl"
#if AGAA_TABLE_SIZE
#include "math/coverage_table.glsl"
#endif

AGAA_AT_CORNERS flat in AGAA_CORNER agaa_corners[3];

// Returns perspective-correct weights of the triangle's corners at an offset from the pixel's centre, in pixels. Points
// outside the triangle are moved inside. The host interpolates its flat attributes by the members at, and dx and dy,
// the change per pixel.
agaa_Barycentrics agaa_cornerWeights(vec2 offset) {
    return agaa_barycentrics(agaa_corners[0].xyz, agaa_corners[1].xyz, agaa_corners[2].xyz, gl_FragCoord.xy + offset,
                             vec2(1.0));
}

#if AGAA_TABLE_SIZE
layout(AGAA_BINDING_COVERAGE_TABLE) uniform usampler2D agaa_coverageTable;

uvec4 agaa_edgeByTable(vec3 a, vec3 b) {
    agaa_CoverageLookup found = agaa_findCoverage(a, b, AGAA_TABLE_SIZE);
    uvec2 texel = agaa_tableTexel(found.entry, AGAA_TABLE_SIZE);
    uvec4 mask = texel.y < AGAA_TABLE_SIZE ? texelFetch(agaa_coverageTable, ivec2(texel), 0) : uvec4(0u);
    return agaa_foundCoverage(found, mask, AGAA_SAMPLES);
}
#endif

// Returns the samples in the triangle.
uvec4 agaa_cornerCoverage() {
#if AGAA_TABLE_SIZE
    vec3 a = agaa_vertexFromCentre(agaa_corners[0].xyz, gl_FragCoord.xy);
    vec3 b = agaa_vertexFromCentre(agaa_corners[1].xyz, gl_FragCoord.xy);
    vec3 c = agaa_vertexFromCentre(agaa_corners[2].xyz, gl_FragCoord.xy);
    return agaa_joinEdges(a, b, c, agaa_edgeByTable(b, c), agaa_edgeByTable(c, a), agaa_edgeByTable(a, b),
                          AGAA_SAMPLES);
#else
    return agaa_triangleCoverage(agaa_corners[0].xyz, agaa_corners[1].xyz, agaa_corners[2].xyz, gl_FragCoord.xy,
                                 AGAA_SAMPLES);
#endif
}

#if AGAA_ALPHA_MASKED
// Tests alpha by bilinear interpolation of the nearest four of 16 points.
bool agaa_isInCutout16(vec4 rows[4], float cutoff, vec2 offset) {
    vec2 at = offset * 4.0 + 1.5;
    ivec2 first = ivec2(clamp(floor(at), vec2(0.0), vec2(2.0)));
    vec2 f = at - vec2(first);
    vec4 low = rows[first.y], high = rows[first.y + 1];
    precise float a = (low[first.x] - cutoff) + (low[first.x + 1] - low[first.x]) * f.x;
    precise float b = (high[first.x] - cutoff) + (high[first.x + 1] - high[first.x]) * f.x;
    precise float margin = a + (b - a) * f.y;
    return margin >= 0.0;
}

uvec4 agaa_cutoutCoverage(AgaaSurfaceInput s, float alpha, vec2 gradient) {
    vec4 near = vec4(agaa_sanitiseAlpha(s.alphaNear.x), agaa_sanitiseAlpha(s.alphaNear.y),
                     agaa_sanitiseAlpha(s.alphaNear.z), agaa_sanitiseAlpha(s.alphaNear.w));
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            s.alphaRows[r][c] = agaa_sanitiseAlpha(s.alphaRows[r][c]);
    uvec4 mask = uvec4(0u);
    for (uint i = 0u; i < AGAA_SAMPLES; ++i) {
        vec2 offset = agaa_coveragePosition(i, AGAA_SAMPLES);
        bool isIn = s.hasAlphaRows   ? agaa_isInCutout16(s.alphaRows, s.alphaCutoff, offset)
                    : s.hasAlphaNear ? agaa_isInCutout4(near, s.alphaCutoff, offset)
                                     : agaa_isInCutout(alpha, s.alphaCutoff, gradient, offset);
        mask[i >> 5u] |= isIn ? 1u << (i & 31u) : 0u;
    }
    return mask;
}

// Returns the samples that alpha covers. It takes derivatives, so it needs uniform control flow.
uvec4 agaa_alphaCoverage(AgaaSurfaceInput s) {
    float alpha = agaa_sanitiseAlpha(s.alpha);
    vec2 gradient = AGAA_FINE_GRADIENT(alpha);
    s.alphaCutoff = agaa_fragmentCutoff(s);
    if (agaa_isCutout(s.alphaCutoff))
        return agaa_cutoutCoverage(s, alpha, gradient);
    uvec2 pixel = agaa_hostPixel();
    uint hash = agaa_translucencyHash(pixel.x, pixel.y, s.primitiveSeed, agaa_frame.ditherFrame);
    uvec4 mask = uvec4(0u);
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        mask[word] = agaa_translucentMask(alpha, 32u, word, AGAA_SAMPLES / 32u, hash);
    return mask;
}
#endif

uvec4 agaa_covered = uvec4(0u); // by agaa_coverageOf(), once it is known
bool agaa_isCoverageKnown = false;

// Returns the samples in the triangle that the alpha of s covers.
uvec4 agaa_coverageOf(AgaaSurfaceInput s) {
    if (agaa_isCoverageKnown)
        return agaa_covered;
    agaa_isCoverageKnown = true;
    agaa_covered = agaa_cornerCoverage();
#if AGAA_ALPHA_MASKED
    agaa_covered &= agaa_alphaCoverage(s);
#endif
    return agaa_covered;
}

// Returns the centroid of the samples that s covers, as an offset from the pixel's centre for agaa_cornerWeights(). The
// host evaluates the material there. It must set the alpha members of s before.
vec2 agaa_coveredMiddle(AgaaSurfaceInput s) { return agaa_coverageMiddle(agaa_coverageOf(s), AGAA_SAMPLES); }
#endif
