// Packs the slopes of a depth plane, and a normal, in one word each.
#ifndef AGAA_PACKED_PLANE_GLSL
#define AGAA_PACKED_PLANE_GLSL
#include "math/encoding.glsl"

// Rounds to the nearest value, ties to even.
uint agaa_packSlope(float slope) {
    uint bits = floatBitsToUint(slope);
    return bits + 0x7FFFu + (bits >> 16u & 1u) >> 16u;
}
uint agaa_packSlopes(vec2 slopes) { return agaa_packSlope(slopes.x) | agaa_packSlope(slopes.y) << 16u; }
vec2 agaa_unpackSlopes(uint word) { return vec2(uintBitsToFloat(word << 16u), uintBitsToFloat(word & 0xFFFF0000u)); }

uint agaa_packNormal(vec3 normal) {
    uvec2 code = uvec2(agaa_encodeOct(normal, 16u) * 65535.0 + 0.5);
    return code.x | code.y << 16u;
}
vec3 agaa_unpackNormal(uint word) { return agaa_decodeOct(vec2(word & 0xFFFFu, word >> 16u) / 65535.0, 16u); }
#endif
