// Converts stored attributes to the means that shading reads. Needs AGAA_EMISSIVE_RANGE.
#ifndef AGAA_STORED_MEANS_GLSL
#define AGAA_STORED_MEANS_GLSL
#ifndef AGAA_EMISSIVE_RANGE
#error "stored_means.glsl needs AGAA_EMISSIVE_RANGE."
#endif
#include "math/encoding.glsl"
#include "aggregate/means.glsl"
#include "common/scene_facts.glsl"
#include "common/stored.glsl"

agaa_Means agaa_meansOfStored(agaa_Stored v) {
    agaa_Means m;
    m.moments = agaa_SecondMoments(vec3(0.0), vec3(0.0)); // agaa_storedMoments() reads them
    m.diffuse = v.diffuse;
#ifdef AGAA_SHADES_CUSTOM
    for (int i = 0; i < AGAA_SHADES_CUSTOM; ++i)
        m.custom[i] = v.custom[i];
    m.classWeight = 0.0;
#endif
    m.normal = v.normal;
    m.lengthBound = agaa_storedLengthBound(1u, agaa_fieldBits(AGAA_FIELD_NORMAL_X));
    m.specular = vec3(0.0);
    m.alpha2 = 1.0;
    if (AGAA_HAS_SPECULAR != 0u) {
        m.specular =
            AGAA_YCBCR_SPECULAR != 0u ? max(agaa_yCbCrToRgb(v.specular), vec3(0.0)) : agaa_storedSpecular(v.specular);
        m.alpha2 = agaa_fieldBits(AGAA_FIELD_ROUGHNESS) != 0u ? v.alpha2 : agaa_factAlpha2(1.0);
    }
    m.emissive = vec3(0.0);
    if (AGAA_EMISSIVE_CHANNELS == 3u)
        m.emissive = AGAA_EMISSIVE_RANGE * v.emissive;
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        m.emissive = AGAA_EMISSIVE_RANGE * v.emissive.x * m.diffuse;
    return m;
}
#endif
