// The coverage samples of a pixel that the alpha of a surface covers. Needs AGAA_ALPHA_INPUT, a type with the alpha
// members of AgaaSurfaceInput, common/frame.glsl and common/scene_facts.glsl.
#ifndef AGAA_MASKED_SAMPLES_GLSL
#define AGAA_MASKED_SAMPLES_GLSL
#if !defined(AGAA_ALPHA_INPUT) || !defined(AGAA_FRAME_GLSL)
#error "masked_samples.glsl needs AGAA_ALPHA_INPUT and frame.glsl."
#endif
#include "math/alpha_coverage.glsl"
#include "math/coverage_pattern.glsl"

// Tests alpha by bilinear interpolation of the nearest four of 16 points.
bool agaa_isInCutout16(vec4 rows[4], float cutoff, vec2 offset) {
    vec2 at = offset * 4.0 + 1.5;
    ivec2 first = ivec2(clamp(floor(at), vec2(0.0), vec2(2.0)));
    vec2 f = at - vec2(first);
    vec4 low = rows[first.y], high = rows[first.y + 1];
    precise float a = (low[first.x] - cutoff) + (low[first.x + 1] - low[first.x]) * f.x;
    precise float b = (high[first.x] - cutoff) + (high[first.x + 1] - high[first.x]) * f.x;
    precise float margin = a + (b - a) * f.y;
    return margin >= 0.0;
}

// Software rasterisers execute all sides of a branch, but leave a loop, so that each kind of alpha has its own loop.
uvec4 agaa_cutoutSamples(AGAA_ALPHA_INPUT s, float alpha, vec2 gradient) {
    bool isPlane = !s.hasAlphaRows && !s.hasAlphaNear, isNear = !s.hasAlphaRows && s.hasAlphaNear;
    vec4 near = vec4(agaa_sanitiseAlpha(s.alphaNear.x), agaa_sanitiseAlpha(s.alphaNear.y),
                     agaa_sanitiseAlpha(s.alphaNear.z), agaa_sanitiseAlpha(s.alphaNear.w));
    for (int r = 0; r < 4 && s.hasAlphaRows; ++r)
        for (int c = 0; c < 4; ++c)
            s.alphaRows[r][c] = agaa_sanitiseAlpha(s.alphaRows[r][c]);
    uvec4 mask = uvec4(0u);
    for (uint i = 0u; i < AGAA_SAMPLES && s.hasAlphaRows; ++i)
        if (agaa_isInCutout16(s.alphaRows, s.alphaCutoff, agaa_coveragePosition(i, AGAA_SAMPLES)))
            mask[i >> 5u] |= 1u << (i & 31u);
    for (uint i = 0u; i < AGAA_SAMPLES && isNear; ++i)
        if (agaa_isInCutout4(near, s.alphaCutoff, agaa_coveragePosition(i, AGAA_SAMPLES)))
            mask[i >> 5u] |= 1u << (i & 31u);
    for (uint i = 0u; i < AGAA_SAMPLES && isPlane; ++i)
        if (agaa_isInCutout(alpha, s.alphaCutoff, gradient, agaa_coveragePosition(i, AGAA_SAMPLES)))
            mask[i >> 5u] |= 1u << (i & 31u);
    return mask;
}

// s          With a sanitised cutoff.
// alpha      Sanitised, at the pixel's centre.
// gradient   Change of alpha per pixel.
uvec4 agaa_maskedSamples(AGAA_ALPHA_INPUT s, float alpha, vec2 gradient, uvec2 pixel) {
    if (agaa_isCutout(s.alphaCutoff))
        return agaa_cutoutSamples(s, alpha, gradient);
    uint hash = agaa_translucencyHash(pixel.x, pixel.y, s.primitiveSeed, agaa_frame.ditherFrame);
    uvec4 mask = uvec4(0u);
#if AGAA_COVERS_TARGET
    const uint texels = AGAA_SCALE_X * AGAA_SCALE_Y * AGAA_LAYERS;
    for (uint texel = 0u; texel < texels; ++texel)
        mask.x |= agaa_translucentMask(alpha, AGAA_HW_SAMPLES, texel, texels, hash) << AGAA_HW_SAMPLES * texel;
#else
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        mask[word] = agaa_translucentMask(alpha, 32u, word, AGAA_SAMPLES / 32u, hash);
#endif
    return mask;
}
#endif
