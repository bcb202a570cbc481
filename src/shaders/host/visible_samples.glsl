// The visible samples of a fragment in a second geometry pass, and the aggregates of the pixel's samples. Needs the
// macros of core/glsl/host_glsl.cpp, and agaa_mayReachFarPlane() of host/far_plane.glsl.
#if !defined(AGAA_AGGREGATES) || !defined(AGAA_REPRESENTED) || !defined(AGAA_POST_DEPTH_COVERAGE)
#error "visible_samples.glsl needs AGAA_AGGREGATES, AGAA_REPRESENTED and AGAA_POST_DEPTH_COVERAGE."
#endif
layout(early_fragment_tests) in;
#if AGAA_POST_DEPTH_COVERAGE
layout(post_depth_coverage) in;
#endif
#if AGAA_AGGREGATES > 1 && !AGAA_REPRESENTED
layout(AGAA_BINDING_METADATA) uniform usampler2D agaa_metadata;
#endif

#if AGAA_CHECKS_FAR_PLANE
layout(AGAA_BINDING_NORMALS) uniform AGAA_TARGET_TEXTURE agaa_normals; // of the first pass; 0: background
#if AGAA_HW_SAMPLES == 1
#define AGAA_NORMAL_OF(i) texelFetch(agaa_normals, ivec2(gl_FragCoord.xy), 0)
#else
#define AGAA_NORMAL_OF(i) texelFetch(agaa_normals, ivec2(gl_FragCoord.xy), i)
#endif

// Returns the samples of the texel that have geometry.
uint agaa_shownSamples() {
    uint shown = 0u;
    for (int i = 0; i < AGAA_HW_SAMPLES; ++i)
        shown |= AGAA_NORMAL_OF(i).x > 0.0 ? 1u << i : 0u;
    return shown;
}
#endif

// Returns the samples of the pixel that this invocation represents.
uint agaa_fragmentMask(AgaaSurfaceInput s) {
#if AGAA_CHECKS_FAR_PLANE
    bool isFar = agaa_mayReachFarPlane(); // derivatives need uniform control flow, so this comes first
#endif
#if AGAA_HW_SAMPLES == 1
    uint mask = 1u;
#elif AGAA_PER_SAMPLE
    uint mask = 1u << gl_SampleID;
#else
    uint mask = uint(gl_SampleMaskIn[0]);
#endif
#if AGAA_ALPHA_MASKED
    mask &= agaa_alphaMask(s);
#endif
#if AGAA_CHECKS_FAR_PLANE
    if (isFar && mask != 0u)
        mask &= agaa_shownSamples();
#endif
    return mask << (agaa_hostGroup() * AGAA_HW_SAMPLES);
}

uvec2 agaa_readPlanes(uvec2 pixel) {
#if AGAA_AGGREGATES > 1 && !AGAA_REPRESENTED
    return agaa_loadedPlanes(texelFetch(agaa_metadata, ivec2(pixel), 0).xy, AGAA_SAMPLES,
                             AGAA_AGGREGATES);
#else
    return uvec2(0u);
#endif
}
