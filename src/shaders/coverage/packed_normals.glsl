// Packs normals, and pairs of numbers with the exponent of a float (bfloat16), in one word each.
#ifndef AGAA_PACKED_NORMALS_GLSL
#define AGAA_PACKED_NORMALS_GLSL
#include "math/encoding.glsl"

// Rounds to the nearest value, ties to even.
uint agaa_packBfloat(float x) {
    uint bits = floatBitsToUint(x);
    return bits + 0x7FFFu + (bits >> 16u & 1u) >> 16u;
}
uint agaa_packBfloats(vec2 v) { return agaa_packBfloat(v.x) | agaa_packBfloat(v.y) << 16u; }
vec2 agaa_unpackBfloats(uint word) { return vec2(uintBitsToFloat(word << 16u), uintBitsToFloat(word & 0xFFFF0000u)); }

uint agaa_packNormal(vec3 normal) {
    uvec2 code = uvec2(agaa_encodeOct(normal, 16u) * 65535.0 + 0.5);
    return code.x | code.y << 16u;
}
vec3 agaa_unpackNormal(uint word) { return agaa_decodeOct(vec2(word & 0xFFFFu, word >> 16u) / 65535.0, 16u); }
#endif
