// Unpacks the words of aggregate/packing.glsl, which must be those of one surface, not sums.
#ifndef AGAA_UNPACKING_GLSL
#define AGAA_UNPACKING_GLSL
#include "aggregate/packing.glsl"

// spirv-opt inlines functions with one return.
float agaa_unpack(uint field) {
    const uint bits = agaa_fieldBits(field);
    float value = 0.0;
    if (bits != 0u) {
        const uint code = bitfieldExtract(agaa_packed[field & 0xFFu], int(field >> 8u & 0xFFu), int(bits));
        value = agaa_isSignedField(field) ? agaa_signedMeanOfSum(code, 1u, bits) : agaa_meanOfSum(code, 1u, bits);
    }
    return value;
}

agaa_Stored agaa_unpackSurface() {
    agaa_Stored v;
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) v.member = agaa_unpack(field);
#include "tables/channels.inc"
    return v;
}
#endif
