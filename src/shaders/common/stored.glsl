// A surface as layouts store it, channel by channel (tables/channels.inc).
#ifndef AGAA_STORED_GLSL
#define AGAA_STORED_GLSL
#include "math/encoding.glsl"
#include "common/custom.glsl"

// A field is word | shift << 8 | bits << 16 | flags << 24. The bits are those of one fragment's value, 0 if the layout
// lacks the channel. Unfiltered fields keep the largest value in place of the sum.
const uint agaa_fieldIsSigned = 1u, agaa_fieldIsUnfiltered = 2u;
uint agaa_fieldBits(uint field) { return field >> 16u & 0xFFu; }
bool agaa_isSignedField(uint field) { return (field >> 24u & agaa_fieldIsSigned) != 0u; }
bool agaa_isUnfilteredField(uint field) { return (field >> 24u & agaa_fieldIsUnfiltered) != 0u; }

// Returns the value to write to a channel of a G-buffer.
float agaa_sourceOf(float value, uint source) {
    uint bits = agaa_fieldBits(source);
    return agaa_isSignedField(source) ? agaa_unormOfCode(vec2(float(agaa_signedCode(value, bits))), bits).x
                                      : agaa_unormOf(value, bits);
}

// Channels are in [0, 1]. The normal and signed custom channels are in [-1, 1].
struct agaa_Stored {
    vec3 diffuse;
    vec3 specular; // luma and chroma in aggregates with AGAA_YCBCR_SPECULAR
    vec3 normal;   // aggregates with AGAA_FOLDED_ROUGHNESS shorten it; in samples, x and y are the octahedral code
    float alpha2;
    vec3 emissive; // divided by the layout's range; with one channel, x is divided by range times diffuse
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
