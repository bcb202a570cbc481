// Which samples of a pixel are shaded together (AGAA section 3.3).
#ifndef AGAA_GROUPING_GLSL
#define AGAA_GROUPING_GLSL
#include "aggregate/pixel_samples.glsl"
#include "math/surfaces.glsl"

// Of the shader that includes this: agaa_weighNormal() of each of these samples, whose materials it knows.
void agaa_weighNormals(uvec2 pixel, uint covered);

// Of the shader that includes this: whether shading normals, where agaa_addSample() was told others, are of one surface.
bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered);

// Of the first n samples, which agaa_setSample() was told: tells them their aggregates, by agaa_sampleAggregate, where they
// are more than one, and returns how many those are.
uint agaa_groupSamples(uvec2 pixel, agaa_PixelSamples samples, uint n) {
    // Distance along a slanted surface would part its samples, though they are shaded nearly alike.
    if (samples.covered == 0u || AGAA_AGGREGATES == 1u ||
        (agaa_areAllOneSurface(n, samples.covered, agaa_frame.surfaceCosine,
                               agaa_surfaceWidth(samples)) &&
         agaa_shadingNormalsAgree(pixel, samples.covered)))
        return min(samples.covered, 1u);
    if (AGAA_GLOSS_WEIGHT != 0u)
        agaa_weighNormals(pixel, samples.covered);
    return agaa_defineAggregates(n, samples.covered, AGAA_AGGREGATES,
                                 agaa_pixelCharacteristicLength(samples), agaa_frame.aggregateThreshold, AGAA_SEEDS);
}
#endif
