// Lists of fragments in the order of the host's draws, and the primitives that fragments are of.
#ifndef AGAA_SORTED_LIST_GLSL
#define AGAA_SORTED_LIST_GLSL
#include "coverage/fragments.glsl"
#include "coverage/list_order.glsl"
#endif
