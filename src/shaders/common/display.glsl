// Colours and luma of the tone-mapped image.
#ifndef AGAA_DISPLAY_GLSL
#define AGAA_DISPLAY_GLSL
// Negative values of a composited background count as 0.
vec3 agaa_displayed(vec3 linear) {
    vec3 light = max(linear, vec3(0.0));
    return pow(light / (1.0 + light), vec3(1.0 / 2.2));
}

float agaa_displayLuma(vec3 linear) {
    return agaa_displayed(vec3(dot(max(linear, vec3(0.0)), vec3(0.2126, 0.7152, 0.0722)))).x;
}
#endif
