// Ids of primitives, by which materials are fetched and fragments are ordered. Needs AGAA_HAS_CORNERS. With
// AGAA_MAX_DRAWS it needs AGAA_MAX_PRIMITIVES, AGAA_PRIMITIVE_BITS and AGAA_SOME_UNFETCHED.
#ifndef AGAA_HOST_IDS_GLSL
#define AGAA_HOST_IDS_GLSL
#ifndef AGAA_HAS_CORNERS
#error "ids.glsl needs AGAA_HAS_CORNERS."
#endif
#include "ids/id_values.glsl"

#ifdef AGAA_MAX_DRAWS
uint agaa_idOfInput(AgaaSurfaceInput s) {
    // Out-of-range primitives are shown as the last primitive of their draw. Out-of-range draws are shown as primitive
    // 0 of the last draw. Ids must name primitives that can be fetched.
    bool isFetched = AGAA_SOME_UNFETCHED == 0 || s.draw != AGAA_UNFETCHED;
    if (isFetched && (s.draw >= AGAA_MAX_DRAWS || s.primitive >= AGAA_MAX_PRIMITIVES) && !AGAA_HELPER)
        agaa_countFragment(AGAA_COUNT_UNANNOUNCED, 1u);
    uint primitive = s.draw < AGAA_MAX_DRAWS ? min(s.primitive, AGAA_MAX_PRIMITIVES - 1u) : 0u;
    uint id = (min(s.draw, AGAA_MAX_DRAWS - 1u) << AGAA_PRIMITIVE_BITS | primitive) + 1u;
    return isFetched ? id : AGAA_UNFETCHED_ID;
}
#endif

#if AGAA_HAS_CORNERS
// Returns the number by which the fragments of a pixel are ordered. Views without an AgaaFetchFunction set no limits,
// so beyond 65536 primitives of a draw, primitives of different draws may share a number.
uint agaa_orderOfInput(AgaaSurfaceInput s) {
#ifdef AGAA_MAX_DRAWS
    return agaa_idOfInput(s);
#else
    return s.draw * 65536u + s.primitive;
#endif
}
#endif
#endif
