// Colour of pixels without geometry. Needs AGAA_COMPOSITE and common/frame.glsl.
#ifndef AGAA_BACKGROUND_GLSL
#define AGAA_BACKGROUND_GLSL
#if !defined(AGAA_COMPOSITE) || !defined(AGAA_FRAME_GLSL)
#error "background.glsl needs AGAA_COMPOSITE and frame.glsl."
#endif
#include "common/output_place.glsl"

#if AGAA_COMPOSITE
// The output is read through a sampler, because not all devices read storage images without a format.
layout(AGAA_BINDING_BACKGROUND) uniform sampler2D agaa_background;
#endif

vec4 agaa_backgroundPixel(ivec2 pixel) {
#if AGAA_COMPOSITE
    if (agaa_opaque(agaa_frame.compositesOutput) != 0u)
        return texelFetch(agaa_background, agaa_placeInOutput(pixel), 0);
#endif
    return agaa_frame.background;
}
#endif
