// Writes the output. Shaded colour is composited over the background by the share of uncovered samples. Needs
// common/frame.glsl, AGAA_BINDING_OUTPUT and AGAA_COMPOSITE.
#ifndef AGAA_OUTPUT_GLSL
#define AGAA_OUTPUT_GLSL
#ifndef AGAA_BINDING_OUTPUT
#error "output.glsl needs AGAA_BINDING_OUTPUT."
#endif
#include "common/background.glsl"
#include "math/display.glsl"
#include "math/sanitise.glsl"

layout(AGAA_BINDING_OUTPUT) writeonly uniform image2D agaa_output;

void agaa_writeOutput(uvec2 pixel, vec3 color, uint covered) {
    vec4 below = agaa_frame.background;
    if (covered < AGAA_SAMPLES) {
        below = agaa_backgroundPixel(ivec2(pixel));
        float rest = float(AGAA_SAMPLES - covered) / float(AGAA_SAMPLES);
        // An empty pixel is exactly the background (hard case 18).
        color = covered == 0u ? below.rgb : color + below.rgb * rest;
    }
    color = agaa_representableColor(color);
    float alpha = AGAA_LUMA_IN_ALPHA != 0u ? agaa_displayLuma(color) : 1.0;
    imageStore(agaa_output, ivec2(pixel), vec4(color, alpha));
}
#endif
