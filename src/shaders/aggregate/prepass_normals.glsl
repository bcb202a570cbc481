// The plane normals of the primitives that the prepass wrote for each sample, in the frame of the pixel's view ray, and
// with AGAA_CLASSES the classes of samples.
// Needs common/target.glsl and AGAA_BINDING_NORMALS.
#ifndef AGAA_PREPASS_NORMALS_GLSL
#define AGAA_PREPASS_NORMALS_GLSL
#if !defined(AGAA_TARGET_GLSL) || !defined(AGAA_BINDING_NORMALS)
#error "prepass_normals.glsl needs target.glsl and AGAA_BINDING_NORMALS."
#endif
#include "math/encoding.glsl"
#include "common/camera.glsl"

layout(AGAA_BINDING_NORMALS) uniform AGAA_TARGET_TEXTURE agaa_normals;

// Returns 0 where there is no geometry.
uvec2 agaa_prepassCode(uvec2 pixel, uint i) { return uvec2(AGAA_FETCH(agaa_normals, pixel, i).xy * 255.0 + 0.5); }

uint agaa_prepassClass(uvec2 pixel, uint i) { return uint(AGAA_FETCH(agaa_normals, pixel, i).z * 255.0 + 0.5); }

// Returns the rotation from the frame of the view ray to view space.
mat3 agaa_prepassFrame(uvec2 pixel) {
    vec2 centre = (vec2(pixel) + 0.5) / vec2(agaa_frame.size) * 2.0 - 1.0;
    vec3 ray = agaa_viewPosition(centre, -1.0, agaa_frame.projectionScale.x, agaa_frame.projectionScale.y,
                                 agaa_frame.projectionOffset.x, agaa_frame.projectionOffset.y,
                                 agaa_isOrthographic());
    vec3 v = agaa_isOrthographic() != 0u ? vec3(0.0, 0.0, 1.0) : normalize(-ray);
    vec3 t, b;
    agaa_viewBasis(v, t, b);
    return mat3(t, b, v);
}

// Returns the mean normal of these samples in shading space, not normalised; 0 if no sample has a normal.
vec3 agaa_meanPrepassNormal(uvec2 pixel, uint mask) {
    vec3 sum = vec3(0.0);
    float count = 0.0;
    for (uint rest = mask; rest != 0u; rest &= rest - 1u) {
        uvec2 code = agaa_prepassCode(pixel, uint(findLSB(rest)));
        if (code != uvec2(0u)) {
            sum += agaa_decodeHemiOct8(code);
            count += 1.0;
        }
    }
    return agaa_toShadingSpace(agaa_prepassFrame(pixel) * sum) / max(count, 1.0);
}
#endif
