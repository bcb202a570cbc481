// Luma of the tone-mapped image.
#ifndef AGAA_DISPLAY_GLSL
#define AGAA_DISPLAY_GLSL
// Negative values of a composited background count as 0.
float agaa_displayLuma(vec3 linear) {
    float y = dot(max(linear, vec3(0.0)), vec3(0.2126, 0.7152, 0.0722));
    return pow(y / (1.0 + y), 1.0 / 2.2);
}
#endif
