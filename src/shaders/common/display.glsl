// Luma as viewers see it: tone-mapped.
#ifndef AGAA_DISPLAY_GLSL
#define AGAA_DISPLAY_GLSL
// A background that is composited over may be negative, which has no luma.
float agaa_displayLuma(vec3 linear) {
    float y = dot(max(linear, vec3(0.0)), vec3(0.2126, 0.7152, 0.0722));
    return pow(y / (1.0 + y), 1.0 / 2.2);
}
#endif
