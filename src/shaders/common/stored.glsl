// A surface as layouts store it, channel by channel (tables/channels.inc).
#ifndef AGAA_STORED_GLSL
#define AGAA_STORED_GLSL
#include "math/encoding.glsl"
#include "common/custom.glsl"

// A field is word | shift << 8 | bits << 16 | flags << 24. bits: of one fragment's value, 0 where the layout has no such
// channel. flags: 1 signed, 2 the largest value instead of the sum.
const uint agaa_fieldIsSigned = 1u, agaa_fieldIsUnfiltered = 2u;
uint agaa_fieldBits(uint field) { return field >> 16u & 0xFFu; }
bool agaa_isSignedField(uint field) { return (field >> 24u & agaa_fieldIsSigned) != 0u; }
bool agaa_isUnfilteredField(uint field) { return (field >> 24u & agaa_fieldIsUnfiltered) != 0u; }

// What to write to a channel of a G-buffer.
float agaa_sourceOf(float value, uint source) {
    uint bits = agaa_fieldBits(source);
    return agaa_isSignedField(source) ? agaa_unormOfCode(vec2(float(agaa_signedCode(value, bits))), bits).x
                                      : agaa_unormOf(value, bits);
}

// Channels in [0,1]; normal and signed custom channels in [-1,1].
struct agaa_Stored {
    vec3 diffuse;
    vec3 specular; // of aggregates luma and chroma, at AGAA_YCBCR_SPECULAR
    vec3 normal;   // of aggregates shorter, at AGAA_FOLDED_ROUGHNESS; of samples x and y are the octahedral code
    float alpha2;
    vec3 emissive; // shares of the layout's range; with one channel, x is a share of range times diffuse
    float custom[8];
};

agaa_Stored agaa_storedSurface(vec3 diffuse, vec3 specular, vec3 normal, float alpha2, vec3 emissive) {
    agaa_Stored v;
    v.diffuse = diffuse;
    v.specular = specular;
    v.normal = normal;
    v.alpha2 = alpha2;
    v.emissive = emissive;
    for (int i = 0; i < 8; ++i)
        v.custom[i] = 0.0;
    return v;
}
#endif
