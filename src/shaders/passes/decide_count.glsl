// How many samples of a pixel are shaded: by both metrics, and by the ways of section 4.2 to make numbers of neighbours alike
// (Hollaender et al. 2013).
#ifndef AGAA_DECIDE_COUNT_GLSL
#define AGAA_DECIDE_COUNT_GLSL
#include "passes/first_samples.glsl"

shared uint agaa_mostOfTile;

// Called by all lanes of a tile. 0 where the pixel shows no geometry; may exceed the number of samples that do.
uint agaa_decideCount(uvec2 pixel, bool isInside) {
    vec4 firstSample = isInside ? agaa_firstSample(ivec2(pixel)) : vec4(0.0);
    uint count = 0u;
    if (firstSample.a != 0.0) {
        float left;
        uint byGeometry = agaa_splitCount(firstSample.a, left);
        count = agaa_countBoth(pixel, byGeometry, left);
    }
    if (agaa_isAdaptive(agaa_tileMaximum)) {
        if (gl_LocalInvocationIndex == 0u)
            agaa_mostOfTile = 0u;
        barrier();
        atomicMax(agaa_mostOfTile, count);
        barrier();
        count = count != 0u ? agaa_mostOfTile : 0u;
    }
    return agaa_isAdaptive(agaa_bucketed) ? min(agaa_bucketOfCount(count), AGAA_SAMPLES) : count;
}
#endif
