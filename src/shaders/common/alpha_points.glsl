// Positions of AgaaSurfaceInput::alphaNear and alphaRows: offsets from the texel's centre, in pixels of the image.
// Needs AGAA_SCALE_X and AGAA_SCALE_Y.
#ifndef AGAA_ALPHA_POINTS_GLSL
#define AGAA_ALPHA_POINTS_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && !defined(AGAA_SCALE_X)
#error "alpha_points.glsl needs AGAA_SCALE_X and AGAA_SCALE_Y."
#endif
vec2 agaa_alphaPoint(uint k) {
    return (vec2(float(k & 1u), float(k >> 1u)) * 0.5 - 0.25) / vec2(AGAA_SCALE_X, AGAA_SCALE_Y);
}
vec2 agaa_alphaRowPoint(uint r, uint c) { return vec2(float(c), float(r)) * 0.25 - 0.375; }
#endif
