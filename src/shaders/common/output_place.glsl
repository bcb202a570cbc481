// The pixels that passes write. Needs common/frame.glsl.
#ifndef AGAA_OUTPUT_PLACE_GLSL
#define AGAA_OUTPUT_PLACE_GLSL
#ifndef AGAA_FRAME_GLSL
#error "output_place.glsl needs frame.glsl."
#endif

// Returns the pixel of the host's output. All frames of most views are at (0, 0).
ivec2 agaa_placeInOutput(ivec2 pixel) { return pixel + ivec2(agaa_frame.outputPlace); }

// Returns the pixel of the image that the pass writes.
ivec2 agaa_placeInWritten(ivec2 pixel) { return AGAA_PLACES_OUTPUT != 0u ? agaa_placeInOutput(pixel) : pixel; }
#endif
