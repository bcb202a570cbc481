// Custom attributes of fetched materials. Needs what ids/fetch.glsl needs.
#ifndef AGAA_FETCHED_CUSTOM_GLSL
#define AGAA_FETCHED_CUSTOM_GLSL
#include "ids/fetch.glsl"
#include "common/custom_filters.glsl"

// Returns the custom attributes, and no others.
agaa_Stored agaa_customOfMaterial(AgaaMaterial m) {
    agaa_Stored v = agaa_storedSurface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, vec3(0.0));
    AGAA_STORE_CUSTOM(m, v)
    return v;
}

uint agaa_classOfMaterial(AgaaMaterial m) {
    return AGAA_CLASS_CHANNEL != 0u ? agaa_classOf(agaa_customOfMaterial(m)) : 0u;
}
#endif
