// Converts a fragment's attributes to those that aggregates sum.
#ifndef AGAA_AGGREGATE_INPUT_GLSL
#define AGAA_AGGREGATE_INPUT_GLSL
#include "math/ndf.glsl"
#include "common/stored.glsl"

agaa_Stored agaa_aggregateInput(agaa_Stored v) {
    if (AGAA_FOLDED_ROUGHNESS != 0u)
        v.normal *= agaa_foldedLength(v.alpha2);
    if (AGAA_YCBCR_SPECULAR != 0u)
        v.specular = agaa_rgbToYCbCr(v.specular);
    return v;
}
#endif
