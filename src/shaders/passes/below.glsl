// What pixels without geometry show.
#ifndef AGAA_BELOW_GLSL
#define AGAA_BELOW_GLSL
#if AGAA_COMPOSITE
// The output through a sampler: reading a storage image without a format is not to be had everywhere.
layout(AGAA_AT_BELOW) uniform sampler2D agaa_below;
#endif

vec4 agaa_belowPixel(ivec2 pixel) {
#if AGAA_COMPOSITE
    if (agaa_unknown(agaa_frame.size.w) != 0u)
        return texelFetch(agaa_below, pixel, 0);
#endif
    return agaa_frame.background;
}
#endif
