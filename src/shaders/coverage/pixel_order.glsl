// Orders the pixels of a tile by the length of their fragment lists. Lanes that execute together wait for the one with
// the longest list. Needs AGAA_ORDERS_PIXELS, common/tile_pixels.glsl and coverage/fragment_words.glsl, and with
// AGAA_SHARED_SURFACES coverage/shared_surfaces.glsl.
#ifndef AGAA_PIXEL_ORDER_GLSL
#define AGAA_PIXEL_ORDER_GLSL
#if !defined(AGAA_ORDERS_PIXELS) || !defined(AGAA_TILE_PIXELS_GLSL) || !defined(AGAA_FRAGMENT_WORDS_GLSL)
#error "pixel_order.glsl needs AGAA_ORDERS_PIXELS, tile_pixels.glsl and fragment_words.glsl."
#endif

const uint agaa_lengths = 16u; // longer lists are not told apart
#if AGAA_SHARED_SURFACES
// The order takes the memory of the surfaces, which GPUs have little of. A barrier precedes the first surface.
#define AGAA_ORDER_WORD(i) agaa_sharedSurfaces[i]
#else
shared uint agaa_orderWords[agaa_lengths + 64u];
#define AGAA_ORDER_WORD(i) agaa_orderWords[i]
#endif
#define AGAA_PIXELS_OF_LENGTH(length) AGAA_ORDER_WORD(length)
#define AGAA_PIXEL_OF_LANE(lane) AGAA_ORDER_WORD(agaa_lengths + (lane))

uint agaa_orderedPixel(uint lane) { return AGAA_PIXEL_OF_LANE(lane); }

// Returns the number of fragments in a pixel's list, at most agaa_lengths - 1.
uint agaa_fragmentsOf(uvec2 pixel) {
    uint count = 0u;
    for (uint fragment = agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size)];
         fragment != 0u && count < agaa_lengths - 1u; ++count)
        fragment = agaa_nextOf(agaa_record(fragment));
    return count;
}

// Gives each lane its pixel. All lanes call it, once. Which of the pixels with lists of one length comes first may
// change between frames; passes do not depend on it.
// isListed   The lists have the fragments of the tile.
void agaa_orderPixels(bool isListed) {
    const uint lane = gl_LocalInvocationIndex;
    if (lane < agaa_lengths)
        AGAA_PIXELS_OF_LENGTH(lane) = 0u;
    AGAA_PIXEL_OF_LANE(lane) = lane;
    const uvec2 pixel = agaa_pixelOf(lane);
    barrier();
    uint length = 0u;
    if (isListed && all(lessThan(pixel, agaa_frame.size)))
        length = agaa_fragmentsOf(pixel);
    uint place = atomicAdd(AGAA_PIXELS_OF_LENGTH(length), 1u);
    barrier();
    for (uint i = 0u; i < agaa_lengths; ++i)
        place += i < length ? AGAA_PIXELS_OF_LENGTH(i) : 0u;
    AGAA_PIXEL_OF_LANE(place) = lane;
    barrier();
}
#endif
