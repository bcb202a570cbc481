// What a kept surface's record says of samples, after its attributes: which samples it stands for, and which
// one is shaded. One word where the mask leaves room, else two. A mask of 0: no surface.
// Source: SBAA (Salvi and Vidimce, I3D 2012), the two bytes a surface of AGAA section 5.4.
#ifndef AGAA_MATH_RECORDS_GLSL
#define AGAA_MATH_RECORDS_GLSL
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
