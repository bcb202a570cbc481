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
#define AGAA_COVERS_BY_TABLE AGAA_TABLE_SIZE
#include "coverage/covered_samples.glsl"

AGAA_AT_CORNERS flat in AGAA_CORNER agaa_corners[3];

// Returns perspective-correct weights of the triangle's corners at an offset from the pixel's centre, in pixels. Points
// outside the triangle are moved inside. The host interpolates its flat attributes by the members at, and dx and dy,
// the change per pixel.
agaa_Barycentrics agaa_cornerWeights(vec2 offset) {
    return agaa_barycentrics(agaa_corners[0].xyz, agaa_corners[1].xyz, agaa_corners[2].xyz, gl_FragCoord.xy + offset,
                             vec2(1.0));
}

// Returns the samples in the triangle.
uvec4 agaa_cornerCoverage() {
    return agaa_coveredSamples(agaa_corners[0].xyz, agaa_corners[1].xyz, agaa_corners[2].xyz, gl_FragCoord.xy);
}

#if AGAA_ALPHA_MASKED
#define AGAA_ALPHA_INPUT AgaaSurfaceInput
#include "coverage/masked_samples.glsl"

// Returns the samples that alpha covers. It takes derivatives, so it needs uniform control flow.
uvec4 agaa_alphaCoverage(AgaaSurfaceInput s) {
    float alpha = agaa_sanitiseAlpha(s.alpha);
    s.alphaCutoff = agaa_fragmentCutoff(s);
    return agaa_maskedSamples(s, alpha, AGAA_FINE_GRADIENT(alpha), agaa_hostPixel());
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
