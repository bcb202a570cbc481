// Declares the colours of surfaces for math/surface_merge.glsl, which it must precede. The function is in
// coverage/merged_surfaces.glsl.
#ifndef AGAA_COLOR_DIFFERENCE_GLSL
#define AGAA_COLOR_DIFFERENCE_GLSL
// Returns the largest difference of a channel of two surfaces, [0, 1].
float agaa_differenceOfColors(uint i, uint k);
#define AGAA_COLOR_DIFFERENCE(i, k) agaa_differenceOfColors(i, k)
#endif
