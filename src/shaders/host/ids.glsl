// Ids of primitives, by which materials are fetched: draw << AGAA_PRIMITIVE_BITS | primitive, from 1 on.
#ifndef AGAA_HOST_IDS_GLSL
#define AGAA_HOST_IDS_GLSL
#include "ids/id_values.glsl"

#ifdef AGAA_MAX_DRAWS
uint agaa_idOfInput(AgaaSurfaceInput s) {
    // What the host did not announce is shown as what it did, since ids must name what can be fetched: a primitive as
    // the last announced, which its draw has; a draw as the first primitive of the last, which may have no other.
    bool isFetched = AGAA_SOME_UNFETCHED == 0 || s.draw != AGAA_UNFETCHED;
    if (isFetched && (s.draw >= AGAA_MAX_DRAWS || s.primitive >= AGAA_MAX_PRIMITIVES) && !AGAA_HELPER)
        agaa_countFragment(AGAA_COUNT_UNANNOUNCED, 1u);
    uint primitive = s.draw < AGAA_MAX_DRAWS ? min(s.primitive, AGAA_MAX_PRIMITIVES - 1u) : 0u;
    uint id = (min(s.draw, AGAA_MAX_DRAWS - 1u) << AGAA_PRIMITIVE_BITS | primitive) + 1u;
    return isFetched ? id : AGAA_UNFETCHED_ID;
}
#endif

#if AGAA_HAS_CORNERS
// By which the fragments of a pixel merge. Views without an AgaaFetchFunction announce no numbers: beyond 65536 primitives
// of a draw, primitives of different draws may share one.
uint agaa_orderOfInput(AgaaSurfaceInput s) {
#ifdef AGAA_MAX_DRAWS
    return agaa_idOfInput(s);
#else
    return s.draw * 65536u + s.primitive;
#endif
}
#endif
#endif
