// Merges fragments into a pixel's surfaces in memory (DCAA sections 3.2 and 3.3). Needs AGAA_MERGE_RULE,
// which common/constants.glsl has, and the functions agaa_readSurfaces(word), agaa_setSurfaces(word, value) and
// agaa_count(counter, amount).
#ifndef AGAA_MERGED_SURFACES_GLSL
#define AGAA_MERGED_SURFACES_GLSL
#if !defined(AGAA_CONSTANTS_GLSL) && !defined(AGAA_MERGE_RULE)
#error "merged_surfaces.glsl needs AGAA_MERGE_RULE."
#endif
#ifndef AGAA_CONSTANTS_GLSL
#define AGAA_STREAMS 0u
#endif
#ifndef AGAA_COLOR_DIFFERENCE_GLSL
#error "merged_surfaces.glsl needs color_difference.glsl, before surface_merge.glsl."
#endif
#include "coverage/covered_surface.glsl"
#include "aggregate/packing.glsl"
#include "coverage/surface_spread.glsl"
#include "aggregate/unpacking.glsl"
#include "common/custom_filters.glsl"

// agaa_roundKept() rounds a kept surface to the values that memory has. agaa_storeKept() stores it without its
// material.
#if AGAA_SHARED_SURFACES
#include "coverage/shared_surfaces.glsl"
void agaa_roundKept(uint i) {} // agaa_keep() has rounded it
vec3 agaa_roundedNormal(uint i) { return agaa_keptAt(i).normal; }
#else
void agaa_roundKept(uint i) { agaa_keep(i, agaa_asStored(agaa_keptAt(i))); }
vec3 agaa_roundedNormal(uint i) { return agaa_asStored(agaa_keptAt(i)).normal; }

void agaa_storeKept(uint base, uint i) {
    agaa_CoveredSurface s = agaa_keptAt(i);
    for (uint word = 0u; word < AGAA_MASK_WORDS; ++word)
        agaa_setSurfaces(base + word, s.mask[word]);
    agaa_StoredPlane stored = agaa_storedPlaneOf(s);
    agaa_setSurfaces(base + AGAA_DEPTH_WORD, floatBitsToUint(stored.depth));
    agaa_setSurfaces(base + AGAA_SLOPE_WORD, stored.slopes);
    agaa_setSurfaces(base + AGAA_NORMAL_WORD, agaa_packNormal(s.normal));
}
#endif

#if defined(AGAA_CONSTANTS_GLSL)
// The depths of samples are in memory, as Kerzner and Salvi have them in a multisampled depth buffer.
uint agaa_nearestDepthsAt = 0u;
float agaa_nearestDepth(uint i) { return uintBitsToFloat(agaa_readSurfaces(agaa_nearestDepthsAt + i)); }
void agaa_setNearestDepth(uint i, float depth) {
    agaa_setSurfaces(agaa_nearestDepthsAt + i, floatBitsToUint(depth));
}
#if AGAA_SHARED_SURFACES
agaa_CoveredSurface agaa_rounded(agaa_CoveredSurface s) { return s; } // agaa_keep() does it
#else
agaa_CoveredSurface agaa_rounded(agaa_CoveredSurface s) { return agaa_asStored(s); }
#endif
#include "math/surface_stream.glsl"

void agaa_beginStream(uvec2 pixel) {
    agaa_nearestDepthsAt = agaa_nearestDepthsOf(pixel);
    for (uint i = 0u; i < AGAA_SAMPLES; i += 4u) { // four at a time, as agaa_takeSamples()
        agaa_setNearestDepth(i, agaa_noDepth());
        agaa_setNearestDepth(i + 1u, agaa_noDepth());
        agaa_setNearestDepth(i + 2u, agaa_noDepth());
        agaa_setNearestDepth(i + 3u, agaa_noDepth());
    }
}
#endif

// Returns the material of the surface whose first word is `base`.
agaa_Stored agaa_loadMaterial(uint base) {
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_packed[w] = agaa_readSurfaces(base + AGAA_MATERIAL_WORD + w);
    return agaa_unpackSurface();
}

// Returns the light that a material reflects, without its lobe.
vec3 agaa_colorOf(agaa_Stored v) { return min(v.diffuse + v.specular, vec3(1.0)); }

// The current fragment is that of the index AGAA_AGGREGATES.
vec3 agaa_currentColor = vec3(0.0);
uvec2 agaa_currentPixel = uvec2(0u);
vec3 agaa_colorOfKept(uint i) {
    return i == AGAA_AGGREGATES ? agaa_currentColor
                                : agaa_colorOf(agaa_loadMaterial(agaa_surfaceBase(agaa_currentPixel, i)));
}

float agaa_differenceOfColors(uint i, uint k) {
    vec3 d = abs(agaa_colorOfKept(i) - agaa_colorOfKept(k));
    return max(d.x, max(d.y, d.z));
}

// Returns the mix of a and b.
// share          Share of b, [0, 1].
// normalLength   Length of the mean normal, by which lobes widen.
agaa_Stored agaa_mixMaterials(agaa_Stored a, agaa_Stored b, float share, float normalLength) {
#define AGAA_ATTRIBUTE(semantic, name)
    const agaa_Stored before = a;
#define AGAA_CHANNEL(index, name, field, source, attribute, member) a.member += (b.member - a.member) * share;
#include "tables/channels.inc"
    uint order = 0u;
    for (int i = 0; i < 8; ++i) {
        bool isClass = uint(i) + 1u == AGAA_CLASS_CHANNEL;
        bool takes = isClass ? share > 0.5 : agaa_takesUnfiltered(order, uint(i), before.custom[i], b.custom[i]);
        if (isClass || agaa_isUnfilteredChannel(uint(i)))
            a.custom[i] = takes ? b.custom[i] : before.custom[i];
    }
    if (AGAA_HAS_SPECULAR != 0u && AGAA_NDF != agaa_ndfNone && AGAA_SPREAD_WORDS == 0u)
        a.alpha2 = agaa_toksvigAlpha2(a.alpha2, normalLength);
    return a;
}

agaa_NormalSpread agaa_loadSpread(uint base) {
    vec3 normal = agaa_unpackNormal(agaa_readSurfaces(base + AGAA_NORMAL_WORD));
    uint at = base + AGAA_SPREAD_WORD;
    return agaa_unpackSpread(normal, uvec2(agaa_readSurfaces(at), agaa_readSurfaces(at + 1u)));
}

// Merges a spread into that of the surface at `base`, and stores the normal that the spread is relative to.
void agaa_mergeSpread(uint base, agaa_NormalSpread spread, float share, vec3 normal) {
    if (share < 1.0)
        spread = agaa_mixSpreads(agaa_loadSpread(base), spread, share, normal);
    uvec2 words = agaa_packSpread(spread);
    agaa_setSurfaces(base + AGAA_NORMAL_WORD, agaa_packNormal(normal));
    agaa_setSurfaces(base + AGAA_SPREAD_WORD, words.x);
    agaa_setSurfaces(base + AGAA_SPREAD_WORD + 1u, words.y);
}

// Merges a material into that of the surface at `base`, with this share.
void agaa_mergeMaterial(uint base, agaa_Stored v, float share, float normalLength) {
    if (share < 1.0)
        v = agaa_mixMaterials(agaa_loadMaterial(base), v, share, normalLength);
    agaa_packSurface(v);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_setSurfaces(base + AGAA_MATERIAL_WORD + w, agaa_packed[w]);
}

void agaa_countInsertion(agaa_Insertion done) {
    if (done.isSecond)
        agaa_count(done.hasMerged ? AGAA_COUNT_MERGED_SECOND : AGAA_COUNT_DISCARDED, 1u);
    else
        agaa_count(AGAA_COUNT_MERGED_FIRST, done.hasMerged ? 1u : 0u);
    agaa_count(AGAA_COUNT_LOST_SAMPLES, done.lost);
}

agaa_MergeRules agaa_mergeRules(uvec2 pixel, float depth) {
    agaa_MergeRules rules;
    rules.limit = agaa_aggregateLimit();
    rules.cosine = agaa_frame.surfaceCosine;
    rules.slack = abs(depth) * 9.5367e-7; // 2^-20
    rules.rule = AGAA_MERGE_RULE;
    rules.streams = AGAA_STREAMS != 0u;
    vec2 pixelsPerNdc = 0.5 * vec2(agaa_frame.size);
    rules.facets = agaa_facetFrame((vec2(pixel) + 0.5) / pixelsPerNdc - 1.0, pixelsPerNdc, agaa_frame.projectionScale,
                                   agaa_frame.projectionOffset, agaa_frame.projection22, agaa_frame.isOrthographic,
                                   AGAA_FAR_DEPTH != 0u ? 1.0 : -1.0);
    return rules;
}

agaa_Insertion agaa_insert(agaa_CoveredSurface s, agaa_MergeRules rules) {
#if defined(AGAA_CONSTANTS_GLSL)
    if (AGAA_STREAMS != 0u)
        return agaa_streamSurface(s, rules, AGAA_SAMPLES);
#endif
    return agaa_insertSurface(s, rules);
}

// Inserts a fragment. Materials and spreads of surfaces are in memory, everything else is kept by
// math/surface_merge.glsl.
// s          Values as stored.
// material   The fragment's material.
// spread     The spread of its normals.
agaa_Insertion agaa_insertFragment(uvec2 pixel, agaa_CoveredSurface s, agaa_Stored material, agaa_NormalSpread spread) {
    agaa_MergeRules rules = agaa_mergeRules(pixel, s.plane.x);
    if (AGAA_UNFILTERED_CHANNELS != 0u) { // surfaces in memory have codes, by which values are compared
        agaa_packSurface(material);
        material = agaa_unpackSurface();
    }
    agaa_currentColor = agaa_colorOf(material);
    agaa_currentPixel = pixel;
    agaa_Insertion done = agaa_insert(s, rules);
    agaa_countInsertion(done);
    if (done.from != AGAA_NO_SURFACE) {
        uint from = agaa_surfaceBase(pixel, done.from);
        agaa_Stored moving = agaa_loadMaterial(from);
        agaa_NormalSpread moved = spread;
        if (AGAA_SPREAD_WORDS != 0u)
            moved = agaa_loadSpread(from);
        if (done.into == rules.limit) {
            material = agaa_mixMaterials(material, moving, done.moved, done.movedLength);
            if (AGAA_SPREAD_WORDS != 0u)
                spread = agaa_mixSpreads(spread, moved, done.moved, agaa_roundedNormal(done.to));
        } else {
            uint into = agaa_surfaceBase(pixel, done.into);
            agaa_mergeMaterial(into, moving, done.moved, done.movedLength);
            agaa_roundKept(done.into);
            if (AGAA_SPREAD_WORDS != 0u)
                agaa_mergeSpread(into, moved, done.moved, agaa_keptAt(done.into).normal);
        }
    }
    if (done.to != AGAA_NO_SURFACE) {
        uint to = agaa_surfaceBase(pixel, done.to);
        agaa_mergeMaterial(to, material, done.share, done.shareLength);
        agaa_roundKept(done.to);
        if (AGAA_SPREAD_WORDS != 0u)
            agaa_mergeSpread(to, spread, done.share, agaa_keptAt(done.to).normal);
    }
    return done;
}

#endif
