// What fragments that carry materials have beside number, next fragment and coverage: the words of a surface but its mask
// (coverage/covered_surface.glsl).
#ifndef AGAA_MATERIAL_PAYLOAD_GLSL
#define AGAA_MATERIAL_PAYLOAD_GLSL
#define AGAA_MATERIAL_PAYLOAD_WORDS (3u + AGAA_SPREAD_WORDS + AGAA_WORDS)
#endif
