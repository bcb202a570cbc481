// Samples whose materials are fetched by id, several of one primitive at once. After adaptive_flags.glsl.
#ifndef AGAA_FETCHED_SAMPLES_GLSL
#define AGAA_FETCHED_SAMPLES_GLSL
#include "ids/fetch.glsl"
#include "ids/sample_ids.glsl"

bool agaa_isCovered(uvec2 pixel, uint i) { return agaa_idOf(pixel, i) != 0u; }

// Those of these samples that show the primitive of sample i.
uint agaa_samplesOfPrimitive(uvec2 pixel, uint i, uint samples) {
    const uint id = agaa_idOf(pixel, i);
    uint own = 0u;
    for (uint rest = samples; rest != 0u; rest &= rest - 1u) {
        uint other = uint(findLSB(rest));
        own |= agaa_idOf(pixel, other) == id ? 1u << other : 0u;
    }
    return own;
}

// The material of a shading event at sample i, in the middle of these samples of its primitive. Textures are filtered over
// their share of the pixel (Hollaender et al. 2013, section 4.1).
void agaa_fetchEvent(uvec2 pixel, uint i, uint samples) {
    const uint own = agaa_samplesOfPrimitive(pixel, i, samples | 1u << i);
    vec2 middle = vec2(0.0);
    for (uint rest = own; rest != 0u; rest &= rest - 1u)
        middle += agaa_sampleLocation(uint(findLSB(rest)));
    middle /= float(bitCount(own));
    const int represented = agaa_isAdaptive(agaa_sampleFootprints) ? 1 : bitCount(own);
    const float width = sqrt(float(represented) / float(AGAA_SAMPLES));
    AgaaPrimitive p = agaa_primitive(agaa_idOf(pixel, i));
    agaa_moveTo(p, pixel, middle);
    p.dx *= width;
    p.dy *= width;
    agaa_fetched = agaa_fetchMaterialThere(p);
}
#endif
