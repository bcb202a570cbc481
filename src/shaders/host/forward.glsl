// Forward pass: shades a fragment once for all its samples, with the lighting of the deferred passes. Needs
// AGAA_SHADOWS, AGAA_SHADOW_MAPS, AGAA_HAS_SPECULAR, AGAA_EMISSIVE_CHANNELS and AGAA_EMISSIVE_RANGE.
#if !defined(AGAA_SHADOWS) || !defined(AGAA_SHADOW_MAPS) || !defined(AGAA_HAS_SPECULAR)
#error "forward.glsl needs AGAA_SHADOWS, AGAA_SHADOW_MAPS and AGAA_HAS_SPECULAR."
#endif
#if !defined(AGAA_EMISSIVE_CHANNELS) || !defined(AGAA_EMISSIVE_RANGE)
#error "forward.glsl needs AGAA_EMISSIVE_CHANNELS and AGAA_EMISSIVE_RANGE."
#endif
layout(early_fragment_tests) in; // hidden fragments are neither shaded nor counted
void agaa_count(uint counter, uint amount) { agaa_countFragment(counter, amount); }
#define AGAA_COMPARE(map, at) textureGrad(map, at, vec2(0.0), vec2(0.0))
#ifdef AGAA_HOST_SHADING
#include "common/host_shading.glsl"
#include "host-code"
#endif
#include "common/lighting.glsl"
#include "gbuffer/forward_color.glsl"

agaa_Surface agaa_forwardSurface(AgaaSurfaceInput s) {
    agaa_Surface surface;
    surface.diffuse = s.diffuse;
    surface.specular = AGAA_HAS_SPECULAR != 0u ? s.specular : vec3(0.0);
    surface.normal = s.normal;
    surface.meanLength = 1.0;
    surface.alpha2 = AGAA_HAS_SPECULAR != 0u ? s.alpha2 : 1.0;
    surface.alpha2Along = 0.0;
    surface.axis = vec3(0.0);
    surface.emissive = AGAA_EMISSIVE_CHANNELS != 0u ? s.emissive : vec3(0.0);
    return surface;
}

// Returns the bits that the fragment's covered samples have in its pixel.
// kept   Samples of the texel that alpha covers.
uint agaa_coveredSamples(uint kept) {
    return (uint(gl_SampleMaskIn[0]) & kept) << agaa_hostGroup() * uint(AGAA_HW_SAMPLES);
}

// Sets the footprint of the samples of this texel that the fragment covers. They lie on the plane of its depth.
// slope   Change of depth per texel.
void agaa_setFragmentFootprint(uint covered, vec2 slope) {
    vec2 perTexel = 2.0 / vec2(agaa_frame.size * uvec2(AGAA_SCALE_X, AGAA_SCALE_Y));
    vec2 centre = agaa_shownPoint(floor(gl_FragCoord.xy) + 0.5);
    vec3 first = vec3(0.0), mean = vec3(0.0);
    agaa_beginFootprint();
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        vec2 offset = agaa_sampleOffset(uint(findLSB(rest)));
        float depth = agaa_depthAtSample(uint(findLSB(rest)), slope);
        float z = agaa_viewZFromDepth(depth, agaa_frame.projection22, agaa_frame.projection32,
                                      agaa_isOrthographic());
        vec3 at = agaa_viewPosition((centre + offset) * perTexel - 1.0, z, agaa_frame.projectionScale.x,
                                    agaa_frame.projectionScale.y, agaa_frame.projectionOffset.x,
                                    agaa_frame.projectionOffset.y, agaa_isOrthographic());
        first = rest == covered ? at : first;
        agaa_addToFootprint(1.0, at - first);
        mean += at - first;
    }
    float count = float(max(bitCount(covered), 1));
    agaa_endFootprintAroundMean(count, mean / count);
}

void agaa_emit(AgaaSurfaceInput s) {
    vec2 slope = vec2(dFdx(gl_FragCoord.z), dFdy(gl_FragCoord.z)); // in uniform control flow
    uint bad = agaa_sanitiseSurface(s, AGAA_EMISSIVE_RANGE) | (agaa_isFinite3(s.position) ? 0u : 1u);
    bool mayReachFarPlane = agaa_mayReachFarPlane();
    uint kept = 0xFFFFFFFFu;
#if AGAA_ALPHA_MASKED
    kept = agaa_alphaMask(s);
#endif
    if (kept != 0u && !AGAA_HELPER) {
        agaa_countSurface(bad);
        agaa_count(AGAA_COUNT_EVENTS, 1u);
#if AGAA_SHADOWS
        for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map)
            agaa_visibility[map] = agaa_shadowTap(map, s.position);
#endif
        if (AGAA_HAS_FOOTPRINT)
            agaa_setFragmentFootprint(uint(gl_SampleMaskIn[0]) & kept, slope);
        agaa_setEvent(agaa_hostPixel(), uvec4(agaa_coveredSamples(kept), 0u, 0u, 0u));
        agaa_Stored custom = agaa_storedSurface(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, vec3(0.0));
        AGAA_STORE_CUSTOM(s, custom)
        agaa_setEventCustom(custom);
        vec3 color = agaa_representableColor(agaa_lightSurface(agaa_forwardSurface(s), s.position));
        agaa_out0 = vec4(mayReachFarPlane ? agaa_markFarPlane(color) : color, 1.0);
    }
#if AGAA_ALPHA_MASKED
    AGAA_KEEP_SAMPLES(kept);
#endif
}
