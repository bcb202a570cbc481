// What pixels without geometry show.
#ifndef AGAA_BACKGROUND_GLSL
#define AGAA_BACKGROUND_GLSL
#if AGAA_COMPOSITE
// The output through a sampler: reading a storage image without a format is not to be had everywhere.
layout(AGAA_BINDING_BACKGROUND) uniform sampler2D agaa_background;
#endif

vec4 agaa_backgroundPixel(ivec2 pixel) {
#if AGAA_COMPOSITE
    if (agaa_opaque(agaa_frame.compositesOutput) != 0u)
        return texelFetch(agaa_background, pixel, 0);
#endif
    return agaa_frame.background;
}
#endif
