// Fragments pass: the coverage of each fragment, with the id of its primitive, becomes a record in the list of its pixel.
// Source: Wang et al., "Decoupled Coverage Anti-Aliasing", I3D 2016, section 3.1.
#include "host/corners.glsl"
#include "math/barycentrics.glsl"
#include "math/triangle_coverage.glsl"

layout(location = AGAA_CORNER_LOCATION) flat in vec3 agaa_corner0;
layout(location = AGAA_CORNER_LOCATION + 1) flat in vec3 agaa_corner1;
layout(location = AGAA_CORNER_LOCATION + 2) flat in vec3 agaa_corner2;

#if AGAA_STORAGE_IMAGES
layout(r32ui, AGAA_AT_FRAGMENTS) uniform uimageBuffer agaa_fragments;
uint agaa_readFragments(uint word) { return imageLoad(agaa_fragments, int(word)).x; }
uint agaa_addToFragments(uint word, uint amount) { return imageAtomicAdd(agaa_fragments, int(word), amount); }
uint agaa_exchangeFragments(uint word, uint value) { return imageAtomicExchange(agaa_fragments, int(word), value); }
void agaa_setFragments(uint word, uint value) { imageStore(agaa_fragments, int(word), uvec4(value)); }
#else
layout(std430, AGAA_AT_FRAGMENTS) buffer agaa_FragmentBlock {
    uint words[];
} agaa_fragments;
uint agaa_readFragments(uint word) { return agaa_fragments.words[word]; }
uint agaa_addToFragments(uint word, uint amount) { return atomicAdd(agaa_fragments.words[word], amount); }
uint agaa_exchangeFragments(uint word, uint value) { return atomicExchange(agaa_fragments.words[word], value); }
void agaa_setFragments(uint word, uint value) { agaa_fragments.words[word] = value; }
#endif
#include "passes/fragment_layout.glsl"

// Perspective-correct weights of the triangle's corners at an offset from the pixel's centre, in pixels. Points outside the
// triangle are moved in. Members: at; dx and dy, their growth per pixel. The host weighs its flat attributes by them.
agaa_Barycentrics agaa_cornerWeights(vec2 offset) {
    return agaa_barycentrics(agaa_corner0, agaa_corner1, agaa_corner2, gl_FragCoord.xy + offset, vec2(1.0));
}

#if AGAA_ALPHA_MASKED
// Bilinear between the four of 16 points that are nearest.
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

uvec4 agaa_cutoutCoverage(AgaaSurfaceInput s, float alpha, vec2 gradient) {
    vec4 near = vec4(agaa_sanitiseAlpha(s.alphaNear.x), agaa_sanitiseAlpha(s.alphaNear.y),
                     agaa_sanitiseAlpha(s.alphaNear.z), agaa_sanitiseAlpha(s.alphaNear.w));
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            s.alphaRows[r][c] = agaa_sanitiseAlpha(s.alphaRows[r][c]);
    uvec4 mask = uvec4(0u);
    for (uint i = 0u; i < AGAA_SAMPLES; ++i) {
        vec2 offset = agaa_coveragePosition(i, AGAA_SAMPLES);
        bool isIn = s.hasAlphaRows   ? agaa_isInCutout16(s.alphaRows, s.alphaCutoff, offset)
                    : s.hasAlphaNear ? agaa_isInCutout4(near, s.alphaCutoff, offset)
                                     : agaa_isInCutout(alpha, s.alphaCutoff, gradient, offset);
        mask[i >> 5u] |= isIn ? 1u << (i & 31u) : 0u;
    }
    return mask;
}

// It takes derivatives, so it needs uniform control flow.
uvec4 agaa_alphaCoverage(AgaaSurfaceInput s) {
    float alpha = agaa_sanitiseAlpha(s.alpha);
    vec2 gradient = AGAA_FINE_GRADIENT(alpha);
    s.alphaCutoff = agaa_sanitiseAlpha(s.alphaCutoff + min(gl_FragCoord.x, 0.0)); // as in agaa_alphaMask()
    if (s.alphaCutoff > 0.0)
        return agaa_cutoutCoverage(s, alpha, gradient);
    uvec2 pixel = agaa_hostPixel();
    uint hash = agaa_translucencyHash(pixel.x, pixel.y, s.primitiveSeed, agaa_frame.dither.x);
    uvec4 mask = uvec4(0u);
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        mask[word] = agaa_translucentMask(alpha, 32u, word, AGAA_SAMPLES / 32u, hash);
    return mask;
}
#endif

void agaa_emit(AgaaSurfaceInput s) {
    uvec4 mask = agaa_triangleCoverage(agaa_corner0, agaa_corner1, agaa_corner2, gl_FragCoord.xy, AGAA_SAMPLES);
#if AGAA_ALPHA_MASKED
    mask &= agaa_alphaCoverage(s);
#endif
    if (agaa_coverageCount(mask) == 0u || AGAA_HELPER)
        return;
    uvec2 pixel = agaa_hostPixel();
    uvec2 size = agaa_frame.size.xy;
    bool isFirstDraw = true;
#if AGAA_HAS_BATCHES
    uint batch = agaa_readFragments(AGAA_LIST_BATCH);
    isFirstDraw = batch == 0u;
    if (isFirstDraw)
        agaa_addToFragments(agaa_tileOf(pixel, size), 1u);
    else if (agaa_readFragments(agaa_tileOf(pixel, size)) != batch)
        return;
#endif
    uint place = agaa_addToFragments(AGAA_LIST_COUNT, 1u);
    uint id = agaa_idOfInput(s);
    if (isFirstDraw)
        agaa_countFragment(AGAA_COUNT_FRAGMENTS, 1u);
    if (place >= agaa_fragmentRoom()) {
        // After the first of several draws there is room in another.
        if (AGAA_HAS_BATCHES == 0 || !isFirstDraw)
            agaa_countFragment(AGAA_COUNT_LOST_FRAGMENTS, 1u);
        return;
    }
    uint base = agaa_recordOf(place + 1u, size, AGAA_HAS_BATCHES == 1);
    uint next = agaa_exchangeFragments(agaa_headOf(pixel, size), place + 1u);
    agaa_setFragments(base, id);
    agaa_setFragments(base + 1u, next);
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        agaa_setFragments(base + 2u + word, mask[word]);
}
