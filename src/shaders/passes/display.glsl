// Colours as viewers see them: tone-mapped.
#ifndef AGAA_DISPLAY_GLSL
#define AGAA_DISPLAY_GLSL
vec3 agaa_display(vec3 linear) { return pow(linear / (1.0 + linear), vec3(1.0 / 2.2)); }

vec3 agaa_linear(vec3 display) {
    vec3 x = pow(display, vec3(2.2));
    return x / max(1.0 - x, vec3(1.0 / 65504.0));
}

// A background that is composited over may be negative, which has no luma.
float agaa_displayLuma(vec3 linear) {
    float y = dot(max(linear, vec3(0.0)), vec3(0.2126, 0.7152, 0.0722));
    return pow(y / (1.0 + y), 1.0 / 2.2);
}
#endif
