// Orders the pixels of a tile by the length of their fragment lists. Lanes that execute together wait for the one with
// the longest list. Needs AGAA_ORDERS_PIXELS, common/tile_pixels.glsl and coverage/fragment_words.glsl.
#ifndef AGAA_PIXEL_ORDER_GLSL
#define AGAA_PIXEL_ORDER_GLSL
#if !defined(AGAA_ORDERS_PIXELS) || !defined(AGAA_TILE_PIXELS_GLSL) || !defined(AGAA_FRAGMENT_WORDS_GLSL)
#error "pixel_order.glsl needs AGAA_ORDERS_PIXELS, tile_pixels.glsl and fragment_words.glsl."
#endif

const uint agaa_longestList = 15u; // longer lists are not told apart
shared uint agaa_pixelsOfLength[agaa_longestList + 1u];

uint agaa_listLength(uvec2 pixel) {
    uint length = 0u;
    for (uint fragment = agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size)];
         fragment != 0u && length < agaa_longestList; ++length)
        fragment = agaa_nextOf(agaa_record(fragment));
    return length;
}

// Gives each lane its pixel. All lanes call it, once. Which of the pixels with lists of one length comes first may
// change between frames; passes do not depend on it.
// isListed   The lists have the fragments of the tile.
void agaa_orderPixels(bool isListed) {
    const uint lane = gl_LocalInvocationIndex;
    if (lane <= agaa_longestList)
        agaa_pixelsOfLength[lane] = 0u;
    agaa_pixelsOfLanes[lane] = lane;
    const uvec2 pixel = agaa_pixelOf(lane);
    barrier();
    uint length = 0u;
    if (isListed && all(lessThan(pixel, agaa_frame.size)))
        length = agaa_listLength(pixel);
    uint place = atomicAdd(agaa_pixelsOfLength[length], 1u);
    barrier();
    for (uint shorter = 0u; shorter < length; ++shorter)
        place += agaa_pixelsOfLength[shorter];
    agaa_pixelsOfLanes[place] = lane;
    barrier();
}
#endif
