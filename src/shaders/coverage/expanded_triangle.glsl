// A triangle of the host in passes that find the pixels and samples that it covers without a rasteriser. They append
// its fragments to lists, or with AGAA_COVERS_TARGET find the nearest primitive of each sample of the target. Needs
// ids/fetch.glsl, common/counters.glsl and coverage/triangle_words.glsl.
#ifndef AGAA_EXPANDED_TRIANGLE_GLSL
#define AGAA_EXPANDED_TRIANGLE_GLSL
#if !defined(AGAA_FETCH_GLSL) || !defined(AGAA_COUNTERS_GLSL) || !defined(AGAA_TRIANGLE_WORDS_GLSL)
#error "expanded_triangle.glsl needs fetch.glsl, counters.glsl and triangle_words.glsl."
#endif
#include "coverage/covered_samples.glsl"
#include "math/depth_plane.glsl" // outside of conditions, because its text is inserted at its first include only
#include "math/hull_rows.glsl"
#define AGAA_ALPHA_INPUT AgaaAlpha
#include "coverage/masked_samples.glsl"

#if AGAA_COVERS_TARGET
#include "ids/nearest_samples.glsl"
#else
#include "coverage/fragment_words.glsl"
uint agaa_readFragments(uint word) { return agaa_fragments.words[word]; }
uint agaa_addToFragments(uint word, uint amount) { return atomicAdd(agaa_fragments.words[word], amount); }
uint agaa_exchangeFragments(uint word, uint value) { return atomicExchange(agaa_fragments.words[word], value); }
uint agaa_lowerFragments(uint word, uint value) { return atomicMin(agaa_fragments.words[word], value); }
uint agaa_raiseFragments(uint word, uint value) { return atomicMax(agaa_fragments.words[word], value); }
void agaa_setFragments(uint word, uint value) { agaa_fragments.words[word] = value; }
uint agaa_listCapacity() { return agaa_frame.fragmentCapacity; }
void agaa_countFragment(uint counter, uint amount) { agaa_count(counter, amount); }
#include "coverage/append_fragment.glsl"
#endif

struct agaa_Corners {
    vec4 a, b, c; // x, y and w in pixels, and z of clip coordinates, for depths in [0, 1]
};

vec4 agaa_cornerOf(vec4 clip) {
    vec3 corner = agaa_vertexInPixels(clip.xyw, 0.5 * vec2(agaa_frame.size));
#if AGAA_CLIP_Z_FROM_MINUS_ONE
    return vec4(corner, 0.5 * (clip.z + clip.w));
#else
    return vec4(corner, clip.z);
#endif
}

agaa_Corners agaa_cornersOf(AgaaPrimitive p) {
    return agaa_Corners(agaa_cornerOf(p.a), agaa_cornerOf(p.b), agaa_cornerOf(p.c));
}

agaa_DepthPlane agaa_planeOf(agaa_Corners corners, vec2 centre) {
    return agaa_depthPlane(corners.a.xyz, corners.b.xyz, corners.c.xyz,
                           vec3(corners.a.w, corners.b.w, corners.c.w), centre);
}

#if AGAA_COVERS_TARGET
// Returns whether the near plane cuts the triangle.
bool agaa_isCut(agaa_Corners corners) {
    vec3 z = vec3(corners.a.w, corners.b.w, corners.c.w);
    vec3 w = vec3(corners.a.z, corners.b.z, corners.c.z);
    return AGAA_FAR_DEPTH != 0u ? any(lessThan(z, vec3(0.0))) : any(greaterThan(z, w));
}
#endif

bool agaa_isCulled(AgaaPrimitive p, AgaaDraw d) {
    float facing = d.culledFacing == 0 ? 0.0 : agaa_facing(p.a.xyw, p.b.xyw, p.c.xyw) * float(sign(d.culledFacing));
    return facing > 0.0;
}

agaa_Outline agaa_outlineOf(AgaaPrimitive p) {
    // Scalars, because glslang turns a choice between constant vectors by a specialisation constant into an instruction
    // that Mesa 22.3's lavapipe evaluates to 0.
    bool isNear0 = AGAA_FAR_DEPTH != 0u;
    float z = isNear0 ? 1.0 : -1.0;
    float w = isNear0 && AGAA_CLIP_Z_FROM_MINUS_ONE == 0 ? 0.0 : 1.0;
    return agaa_triangleOutline(p.a, p.b, p.c, vec2(z, w), 0.5 * vec2(agaa_frame.size));
}

#if AGAA_EXPANDS_MASKED
// Counts what the mask of a fragment demands, once in a frame.
void agaa_countMask(float cutoff) {
    if (AGAA_CHECK_FACTS == 0u || !agaa_isFirstDraw())
        return;
    agaa_count(AGAA_COUNT_ALPHA_MASKED, 1u);
    agaa_count(cutoff > 0.0 ? AGAA_COUNT_CUTOUTS : AGAA_COUNT_TRANSLUCENT, 1u);
}

// Returns those of the covered samples that alpha covers, too.
uvec4 agaa_alphaSamples(AgaaPrimitive p, uvec2 pixel, uvec4 covered) {
    if (!agaa_drawOf(p.draw).isAlphaMasked)
        return covered;
    agaa_expandedPixel = pixel;
    agaaMoveTo(p, vec2(0.0));
    AgaaAlpha a = AgaaAlpha(1.0, 0.0, false, vec4(1.0), false, vec4[4](vec4(1.0), vec4(1.0), vec4(1.0), vec4(1.0)), 0u);
    agaaHostAlpha(p, a);
    a.alphaCutoff = agaa_sanitiseAlpha(a.alphaCutoff);
    uvec4 mask = agaa_maskedSamples(a, agaa_sanitiseAlpha(a.alpha), vec2(0.0), pixel) & covered;
    if (agaa_coverageCount(mask) != 0u)
        agaa_countMask(a.alphaCutoff);
    return mask;
}
#endif

// Keeps the fragment of a triangle in a pixel, if it covers samples.
void agaa_expandPixel(uint id, AgaaPrimitive p, uvec2 pixel) {
    agaa_Corners corners = agaa_cornersOf(p);
    vec2 centre = vec2(pixel) + 0.5;
    uvec4 mask = agaa_coveredSamples(corners.a.xyz, corners.b.xyz, corners.c.xyz, centre);
#if AGAA_COVERS_TARGET
    agaa_DepthPlane plane = agaa_planeOf(corners, centre);
    bool isCut = agaa_isCut(corners);
    agaa_OpenSamples samples = agaa_openSamples(pixel, mask.x, plane, isCut);
    // Hidden surfaces need no alpha, unless the report of facts counts them.
    mask.x = AGAA_CHECK_FACTS != 0u && agaa_isFirstDraw() ? samples.inRange : samples.open;
#endif
#if AGAA_EXPANDS_MASKED
    // Software rasterisers execute both sides of a branch, but leave a loop.
    for (uint k = 0u; k < 1u && agaa_coverageCount(mask) != 0u; ++k)
        mask = agaa_alphaSamples(p, pixel, mask);
#endif
    if (agaa_coverageCount(mask) == 0u)
        return;
#if AGAA_COVERS_TARGET
    agaa_keepSamples(pixel, id, mask.x & samples.open, plane, isCut);
#else
    agaa_appendFragment(pixel, id, mask, agaa_planeOf(corners, centre));
#endif
}
#endif
