// Ids of primitives: (draw << AGAA_PRIMITIVE_BITS | primitive) + 1. The id 0 means no geometry.
#ifndef AGAA_ID_VALUES_GLSL
#define AGAA_ID_VALUES_GLSL
#define AGAA_UNFETCHED_ID 0xFFFFFFFFu // draws that a G-buffer holds instead (AGAA_FETCH_NOT_ALL_DRAWS)
#endif
