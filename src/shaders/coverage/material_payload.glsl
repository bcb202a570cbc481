// Payload of fragments in material lists: the words of a surface without its mask (coverage/covered_surface.glsl).
// Number, next fragment and coverage precede it.
#ifndef AGAA_MATERIAL_PAYLOAD_GLSL
#define AGAA_MATERIAL_PAYLOAD_GLSL
#define AGAA_MATERIAL_PAYLOAD_WORDS (3u + AGAA_SPREAD_WORDS + AGAA_WORDS)
#endif
