// What an aggregate's attributes are in the mean over its samples.
#ifndef AGAA_MEANS_GLSL
#define AGAA_MEANS_GLSL
#include "math/ndf.glsl"

struct agaa_Means {
    vec3 diffuse;
    vec3 specular;
    vec3 emissive;     // radiance
    vec3 normal;       // as long as the normals agree
    float alpha2;
    float lengthBound; // what rounding may have made the normal shorter by
    agaa_NormalMoments moments; // with AGAA_NDF from AGAA_NDF_LEAN on
};
#endif
