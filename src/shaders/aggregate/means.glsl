// Means of an aggregate's attributes over its samples.
#ifndef AGAA_MEANS_GLSL
#define AGAA_MEANS_GLSL
#include "math/ndf.glsl"

// True if means have second moments of normals.
#define AGAA_KEEPS_MOMENTS \
    (AGAA_FILTER_DIFFUSE == agaa_diffuseSggx || (AGAA_HAS_SPECULAR != 0u && AGAA_NDF >= agaa_ndfLean))

struct agaa_Means {
    vec3 diffuse;
    vec3 specular;
    vec3 emissive;     // radiance
    vec3 normal;       // its length is 1 if all normals agree
    float alpha2;
    float lengthBound; // by which rounding may have shortened the normal
    agaa_SecondMoments moments; // if AGAA_KEEPS_MOMENTS
#ifdef AGAA_SHADES_CUSTOM        // number of channels of custom attributes, if functions of the host shade with them
    float custom[AGAA_SHADES_CUSTOM];
    float classWeight; // by which the class exceeds the others
#endif
};

// Sets the custom attributes of the event.
void agaa_setEventCustom(agaa_Means m) {
#ifdef AGAA_SHADES_CUSTOM
    agaa_eventCustom = m.custom;
#endif
}

// Sets the attributes of an event with means over its samples that functions of the host read.
void agaa_setEventMeans(agaa_Means m) {
    agaa_setEventCustom(m);
#ifdef AGAA_LIGHTING_GLSL // not in shaders of the host that read aggregates
    agaa_eventMoments = m.moments;
#endif
#ifdef AGAA_HOST_SHADING
    agaa_eventAlpha2 = m.alpha2;
#endif
}
#endif
