// Converts a fetched material to the channels of a layout. Needs common/frame.glsl and common/constants.glsl.
#ifndef AGAA_STORED_MATERIAL_GLSL
#define AGAA_STORED_MATERIAL_GLSL
#if !defined(AGAA_FRAME_GLSL) || !defined(AGAA_CONSTANTS_GLSL)
#error "stored_material.glsl needs frame.glsl and constants.glsl."
#endif
#include "common/host_code.glsl"
#include "common/stored.glsl"

agaa_Stored agaa_storedMaterial(AgaaMaterial m) {
    vec3 emissive = m.emissive / agaa_frame.emissiveRange;
    if (AGAA_EMISSIVE_CHANNELS == 1u)
        emissive = vec3(agaa_emissiveFactor(m.diffuse, emissive));
    agaa_Stored v = agaa_storedSurface(m.diffuse, m.specular, m.normal, m.alpha2, emissive);
    AGAA_STORE_CUSTOM(m, v)
    return v;
}
#endif
