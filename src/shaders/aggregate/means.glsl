// Means of an aggregate's attributes over its samples.
#ifndef AGAA_MEANS_GLSL
#define AGAA_MEANS_GLSL
#include "math/ndf.glsl"

struct agaa_Means {
    vec3 diffuse;
    vec3 specular;
    vec3 emissive;     // radiance
    vec3 normal;       // its length is 1 if all normals agree
    float alpha2;
    float lengthBound; // by which rounding may have shortened the normal
    agaa_NormalMoments moments; // used by elliptic lobes
#ifdef AGAA_SHADES_CUSTOM        // number of channels of custom attributes, if functions of the host shade with them
    float custom[AGAA_SHADES_CUSTOM];
#endif
};

// Sets the custom attributes of the event.
void agaa_setEventCustom(agaa_Means m) {
#ifdef AGAA_SHADES_CUSTOM
    agaa_eventCustom = m.custom;
#endif
}
#endif
