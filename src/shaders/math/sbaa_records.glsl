// The record of a kept surface, after its attributes: the samples that it represents, and the one that is shaded. It
// has one word if the mask leaves room, otherwise two. A mask of 0 means no surface.
// Source: SBAA (Salvi and Vidimce, I3D 2012), the two bytes a surface of AGAA section 5.4.
#ifndef AGAA_MATH_SBAA_RECORDS_GLSL
#define AGAA_MATH_SBAA_RECORDS_GLSL
#include "real.glsl"

uvec2 agaa_storedSurface(uint samples, uint shaded, uint n) {
    return n > 16u ? uvec2(samples, shaded) : uvec2(samples | (shaded << 16u), 0u);
}

uint agaa_recordSamples(uvec2 record, uint n) {
    return n > 16u ? record.x : record.x & 0xFFFFu;
}

uint agaa_recordShaded(uvec2 record, uint n) {
    return n > 16u ? record.y & 31u : (record.x >> 16u) & 31u;
}

#endif
