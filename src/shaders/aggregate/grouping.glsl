// Groups the samples of a pixel that are shaded together (AGAA section 3.3). Needs AGAA_MAX_SAMPLES and
// common/frame.glsl.
#ifndef AGAA_GROUPING_GLSL
#define AGAA_GROUPING_GLSL
#include "aggregate/pixel_samples.glsl"
#include "math/sbaa_surfaces.glsl"

// The includer defines this function. It calls agaa_weighNormal() for each of these samples.
void agaa_weighNormals(uvec2 pixel, uint covered);

// The includer defines this function. It returns whether the shading normals are those of one surface, if
// agaa_addSample() received other normals.
bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered);

// Returns the number of aggregates of the first n samples, which agaa_setSample() set. If there are several, writes the
// aggregates of the samples to agaa_sampleAggregate, and agaa_joiningSamples.
uint agaa_groupSamples(uvec2 pixel, agaa_PixelSamples samples, uint n) {
    // The samples of one surface are shaded nearly alike. Clustering would split a slanted surface by distance.
    agaa_joiningSamples = 0u;
    if (samples.covered == 0u || AGAA_AGGREGATES == 1u ||
        (agaa_areAllOneClass(n, samples.covered) &&
         agaa_areAllOneSurface(n, samples.covered, agaa_frame.surfaceCosine,
                               agaa_surfaceWidth(samples)) &&
         agaa_shadingNormalsAgree(pixel, samples.covered)))
        return min(samples.covered, 1u);
    if (AGAA_GLOSS_WEIGHT != 0u)
        agaa_weighNormals(pixel, samples.covered);
    return agaa_defineAggregates(n, samples.covered, AGAA_AGGREGATES,
                                 agaa_pixelCharacteristicLength(samples), agaa_frame.aggregateThreshold, AGAA_SEEDS);
}
#endif
