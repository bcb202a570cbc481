// Functions of the host's that a pass is compiled with, and what they speak of.
#ifndef AGAA_HOST_CODE_GLSL
#define AGAA_HOST_CODE_GLSL
// Where sample i lies in a target whose pixels are AGAA_SCALE_X x AGAA_SCALE_Y texels of AGAA_HW_SAMPLES each.
ivec2 agaaTexel(uvec2 pixel, uint i) {
    uint group = i / AGAA_HW_SAMPLES;
    return ivec2(pixel * uvec2(AGAA_SCALE_X, AGAA_SCALE_Y) +
                 uvec2(group % AGAA_SCALE_X, group / AGAA_SCALE_X));
}
int agaaTexelSample(uint i) { return int(i % AGAA_HW_SAMPLES); }

#if defined(AGAA_HOST_GBUFFER) || defined(AGAA_HOST_FETCH)
#include "common/custom.glsl"

struct AgaaMaterial { // as in AgaaSurfaceInput, but for normalDx and normalDy
    vec3 diffuse;
    vec3 specular;
    vec3 emissive;
    vec3 normal; // shading space, unit
    float alpha2;
    // Of what is fetched by id: derivatives of `normal` by the image's x and y, a pixel each. Of a vertex normal N that
    // grows by d from pixel to pixel, as AgaaPrimitive's weights tell, it is (d - n * dot(n, d)) / |N|, negated where
    // the normal was. 0: one normal stands for all samples of the primitive.
    vec3 normalDx, normalDy;
    AGAA_CUSTOM_MEMBERS // of the layout's
};

#endif
#ifdef AGAA_HOST_FETCH

// A primitive that the prepass left the id of, and a point of it that a pixel shows.
struct AgaaPrimitive {
    uint draw;
    uint primitive;
    vec4 a, b, c; // clip coordinates of its vertices by AgaaFrame::projection, as agaaHostTriangle() gave them
    vec3 at;      // weights of the vertices at the point, perspective-correct, [0;1]
    vec3 dx, dy;  // change of the weights from one pixel of the image to the next; of a shaded sample of "adaptive", times
                  // the square root of the share of the pixel that it represents
    float facing; // > 0 where a, b, c turn from x to y of the image, < 0 where the other way
};

#endif
#if defined(AGAA_HOST_GBUFFER) || defined(AGAA_HOST_FETCH) || defined(AGAA_HOST_SHADOWS)
#include "host-code"
#endif
#endif
