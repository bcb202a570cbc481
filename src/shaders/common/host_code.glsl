// Functions of the host that a pass is compiled with, and their types. Needs common/frame.glsl, and AGAA_HW_SAMPLES,
// AGAA_SCALE_X, AGAA_SCALE_Y and AGAA_LAYERS, which common/constants.glsl has.
#ifndef AGAA_HOST_CODE_GLSL
#define AGAA_HOST_CODE_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && (!defined(AGAA_HW_SAMPLES) || !defined(AGAA_SCALE_X) || !defined(AGAA_SCALE_Y))
#error "host_code.glsl needs AGAA_HW_SAMPLES, AGAA_SCALE_X and AGAA_SCALE_Y."
#endif
#if !defined(AGAA_FRAME_GLSL) || (!defined(AGAA_CONSTANTS_GLSL) && !defined(AGAA_LAYERS))
#error "host_code.glsl needs frame.glsl and AGAA_LAYERS."
#endif
#include "common/alpha_points.glsl"
#include "common/custom.glsl"

// Returns the texel of sample i in a target whose pixels are AGAA_SCALE_X x AGAA_SCALE_Y texels of AGAA_HW_SAMPLES
// each, or a texel in each of AGAA_LAYERS layers.
ivec2 agaaTexel(uvec2 pixel, uint i) {
    uint group = i / AGAA_HW_SAMPLES;
    if (AGAA_LAYERS > 1u)
        return ivec2(pixel.x, pixel.y + group * agaa_frame.size.y);
    return ivec2(pixel * uvec2(AGAA_SCALE_X, AGAA_SCALE_Y) +
                 uvec2(group % AGAA_SCALE_X, group / AGAA_SCALE_X));
}
int agaaTexelSample(uint i) { return int(i % AGAA_HW_SAMPLES); }

#if defined(AGAA_HOST_GBUFFER) || defined(AGAA_HOST_FETCH)

struct AgaaMaterial { // as in AgaaSurfaceInput, but for normalDx and normalDy
    vec3 diffuse;
    vec3 specular;
    vec3 emissive;
    vec3 normal; // shading space, unit
    float alpha2;
    // Read from materials that are fetched by id: derivatives of `normal` by the image's x and y, per pixel. If the
    // vertex normal N changes by d per pixel, by AgaaPrimitive::dx or dy, the derivative is (d - n * dot(n, d)) / |N|,
    // negated if the normal was negated. With 0, all samples of the primitive have one normal.
    vec3 normalDx, normalDy;
    AGAA_CUSTOM_MEMBERS // custom attributes of the layout
};

#endif
#ifdef AGAA_HOST_FETCH

// A primitive, by its id, and a point on it that a pixel shows.
struct AgaaPrimitive {
    uint draw;
    uint primitive;
    vec4 a, b, c; // clip coordinates of its vertices by AgaaFrame::projection, as agaaHostTriangle() gave them
    vec3 at;      // weights of the vertices at the point, perspective-correct, [0;1]
    // change of the weights per pixel of the image; in "adaptive" times the square root of the share of the pixel that
    // the shaded sample represents
    vec3 dx, dy;
    float facing; // > 0 if a, b, c turn from x to y of the image, < 0 if they turn the other way
};

#endif
#if defined(AGAA_HOST_FETCH) && defined(AGAA_EXPANDS_TRIANGLES)
#include "common/host_triangles.glsl"
#endif
#ifdef AGAA_HOST_SHADOWS
#include "common/host_footprint.glsl"
#endif
#ifdef AGAA_HOST_SHADING
#include "common/host_shading.glsl"
#endif
#if defined(AGAA_HOST_GBUFFER) || defined(AGAA_HOST_FETCH) || defined(AGAA_HOST_SHADOWS) || defined(AGAA_HOST_SHADING)
#include "host-code"
#endif
#endif
