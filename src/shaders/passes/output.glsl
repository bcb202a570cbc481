// The host's image. Shaded colour is composited over the background with the uncovered share.
#ifndef AGAA_OUTPUT_GLSL
#define AGAA_OUTPUT_GLSL
layout(set = AGAA_SET, binding = 11) uniform image2D agaa_output;

void agaa_writeOutput(uvec2 pixel, vec3 color, uint covered) {
    vec4 below = agaa_frame.background;
    if (covered < AGAA_SAMPLES) {
        if (agaa_frame.size.w != 0u)
            below = imageLoad(agaa_output, ivec2(pixel));
        float rest = float(AGAA_SAMPLES - covered) / float(AGAA_SAMPLES);
        // An empty pixel is exactly the background (hard case 18).
        color = covered == 0u ? below.rgb : color + below.rgb * rest;
    }
    imageStore(agaa_output, ivec2(pixel), vec4(color, 1.0));
}
#endif
