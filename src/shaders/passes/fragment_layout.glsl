// Words of the buffer of lists: counts, the first fragment of each pixel, then the fragments.
//
// A fragment is the id of its primitive, the next fragment of its pixel, and its coverage. Fragments are numbered from 1; 0
// ends a list.
#ifndef AGAA_FRAGMENT_LAYOUT_GLSL
#define AGAA_FRAGMENT_LAYOUT_GLSL
#define AGAA_LIST_COUNT 0u  // fragments that asked for a place
#define AGAA_LIST_HEADS 16u // where the first fragments begin
#define AGAA_FRAGMENT_WORDS (2u + AGAA_SAMPLES / 32u)

uint agaa_headOf(uvec2 pixel, uint width) { return AGAA_LIST_HEADS + pixel.y * width + pixel.x; }
uint agaa_recordOf(uint fragment, uint pixels) { return AGAA_LIST_HEADS + pixels + (fragment - 1u) * AGAA_FRAGMENT_WORDS; }
#endif
