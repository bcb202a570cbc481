// Writes the output. Shaded colour is composited over the background by the share of uncovered samples. Needs
// common/frame.glsl, AGAA_BINDING_OUTPUT and AGAA_COMPOSITE.
//
// With AGAA_CONFIG_HDR_RESOLVE, sums over events and samples are sums of agaa_weightedLight().
#ifndef AGAA_OUTPUT_GLSL
#define AGAA_OUTPUT_GLSL
#ifndef AGAA_BINDING_OUTPUT
#error "output.glsl needs AGAA_BINDING_OUTPUT."
#endif
#include "common/background.glsl"
#include "common/output_place.glsl"
#include "math/display.glsl"
#include "math/hdr_weight.glsl"
#include "math/sanitise.glsl"

layout(AGAA_BINDING_OUTPUT) writeonly uniform image2D agaa_output;

// Returns the light of an event as pixels sum it.
vec3 agaa_weightedLight(vec3 light) {
    if (AGAA_HDR_RESOLVE == 0u)
        return light;
    return agaa_weightByLuminance(agaa_representableColor(light), agaa_frame.exposure);
}

// color   The sum of the events' agaa_weightedLight(), each times its share of the pixel.
void agaa_writeOutput(uvec2 pixel, vec3 color, uint covered) {
    vec3 below = vec3(0.0);
    if (covered < AGAA_SAMPLES) {
        below = agaa_backgroundPixel(ivec2(pixel)).rgb;
        float rest = float(AGAA_SAMPLES - covered) / float(AGAA_SAMPLES);
        color += agaa_weightedLight(below) * rest;
    }
    if (AGAA_HDR_RESOLVE != 0u)
        color = agaa_lightOfWeightedMean(color, agaa_frame.exposure);
    color = covered == 0u ? below : color; // exactly the background (hard case 18)
    color = agaa_representableColor(color);
    float alpha = AGAA_LUMA_IN_ALPHA != 0u ? agaa_displayLuma(color) : 1.0;
    imageStore(agaa_output, agaa_placeInWritten(ivec2(pixel)), vec4(color, alpha));
}
#endif
