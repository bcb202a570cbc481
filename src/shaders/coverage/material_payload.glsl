// Payload of fragments in material lists: the words of a surface without its mask (coverage/covered_surface.glsl).
// Number, next fragment and coverage precede it. Needs AGAA_SPREAD_WORDS and AGAA_WORDS, which common/constants.glsl
// has.
#ifndef AGAA_MATERIAL_PAYLOAD_GLSL
#define AGAA_MATERIAL_PAYLOAD_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && (!defined(AGAA_SPREAD_WORDS) || !defined(AGAA_WORDS))
#error "material_payload.glsl needs AGAA_SPREAD_WORDS and AGAA_WORDS."
#endif
#include "tables/layouts.inc"
#define AGAA_MATERIAL_PAYLOAD_WORDS (AGAA_PLANE_WORDS + AGAA_SPREAD_WORDS + AGAA_WORDS)
#endif
