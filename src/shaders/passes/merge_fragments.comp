// Merges the fragments of each pixel, in the order of their ids, into surfaces in memory (DCAA sections 3.2 and 3.3).
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_REPRESENTED 1
layout(local_size_x = 8, local_size_y = 8) in;
#include "passes/bindings.glsl"
#include "passes/constants.glsl"
#include "passes/frame.glsl"
#include "passes/target.glsl"
#include "passes/counters.glsl"
#include "math/light.glsl"
#include "math/depth_plane.glsl"
#include "passes/tile_pixels.glsl"
#include "passes/fetch.glsl"
#include "passes/sorted_list.glsl"
#include "passes/covered_surface.glsl"
#include "passes/packing.glsl"
#include "passes/stored_material.glsl"

layout(std430, AGAA_AT_AGGREGATES) buffer agaa_SurfaceBlock {
    uint words[];
} agaa_surfaces;

#define AGAA_AGGREGATE_WORD(i) agaa_surfaces.words[i]
#define AGAA_IMAGE_WIDTH agaa_frame.size.x
#define AGAA_EMISSIVE_RANGE agaa_frame.ambient.w
#include "passes/stored_aggregate.glsl"

// Of the pixel's surface at `base`.
agaa_Stored agaa_loadMaterial(uint base) {
    agaa_base = base + AGAA_MATERIAL_WORD;
    return agaa_storedMeans();
}

// The share is of b. normalLength: of the mean normal, by which lobes widen.
agaa_Stored agaa_mixMaterials(agaa_Stored a, agaa_Stored b, float share, float normalLength) {
#define AGAA_ATTRIBUTE(semantic, name)
#define AGAA_CHANNEL(index, name, field, source, attribute, member) a.member += (b.member - a.member) * share;
#include "channels.inc"
    if (AGAA_HAS_SPECULAR != 0u && AGAA_NDF != 0u)
        a.alpha2 = agaa_toksvigAlpha2(a.alpha2, normalLength);
    return a;
}

// Lets a surface have this share of another material.
void agaa_giveMaterial(uint base, agaa_Stored v, float share, float normalLength) {
    if (share < 1.0)
        v = agaa_mixMaterials(agaa_loadMaterial(base), v, share, normalLength);
    agaa_packSurface(v);
    for (uint w = 0u; w < AGAA_WORDS; ++w)
        agaa_surfaces.words[base + AGAA_MATERIAL_WORD + w] = agaa_packed[w];
}

void agaa_countInsertion(agaa_Insertion done, bool isNew) {
    bool gave = done.from != AGAA_NO_SURFACE || (done.to != AGAA_NO_SURFACE && done.share < 1.0);
    if (done.isSecond)
        agaa_count(gave ? AGAA_COUNT_MERGED_SECOND : AGAA_COUNT_DISCARDED, 1u);
    else if (!isNew)
        agaa_count(AGAA_COUNT_MERGED_FIRST, 1u);
    agaa_count(AGAA_COUNT_LOST_SAMPLES, done.lost);
}

void agaa_insertFragment(uvec2 pixel, uint record, agaa_MergeRules rules) {
    agaa_CoveredSurface s;
    s.mask = agaa_maskOf(record);
    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
    agaa_DepthPlane plane = agaa_planeOf(p, pixel);
    if (agaa_isFar(plane))
        return;
    agaa_moveTo(p, pixel, agaa_coverageMiddle(s.mask, AGAA_SAMPLES) + 0.5);
    AgaaMaterial m = agaa_fetchMaterialThere(p);
    agaa_widenByCurvature(m, s.mask);
    s.plane = agaa_growingDepth(plane);
    s.normal = m.normal;
    s = agaa_asStored(s);
    rules.slack = abs(s.plane.x) * 9.5367e-7;
    uint before = agaa_keptCount;
    agaa_Insertion done = agaa_insertSurface(s, rules);
    agaa_countInsertion(done, agaa_keptCount > before);
    agaa_Stored own = agaa_storedMaterial(m);
    if (done.from != AGAA_NO_SURFACE) {
        agaa_Stored moving = agaa_loadMaterial(agaa_surfaceBase(pixel, done.from));
        if (done.into == rules.limit)
            own = agaa_mixMaterials(own, moving, done.moved, done.movedLength);
        else
            agaa_giveMaterial(agaa_surfaceBase(pixel, done.into), moving, done.moved, done.movedLength);
        agaa_keep(done.into, agaa_asStored(agaa_kept[done.into]));
    }
    if (done.to != AGAA_NO_SURFACE) {
        agaa_giveMaterial(agaa_surfaceBase(pixel, done.to), own, done.share, done.shareLength);
        agaa_keep(done.to, agaa_asStored(agaa_kept[done.to]));
    }
}

void agaa_storeSurface(uint base, uint a) {
    bool exists = a < agaa_keptCount;
    agaa_CoveredSurface s = agaa_kept[a];
    for (uint word = 0u; word < AGAA_MASK_WORDS; ++word)
        agaa_surfaces.words[base + word] = exists ? s.mask[word] : 0u;
    if (!exists)
        return;
    agaa_surfaces.words[base + AGAA_DEPTH_WORD] = floatBitsToUint(s.plane.x);
    agaa_surfaces.words[base + AGAA_SLOPE_WORD] = agaa_packSlopes(s.plane.yz);
    agaa_surfaces.words[base + AGAA_NORMAL_WORD] = agaa_packNormal(s.normal);
}

void agaa_mergePixel(uvec2 pixel) {
    agaa_MergeRules rules = agaa_MergeRules(agaa_aggregateLimit(), agaa_frame.surface.x, 0.0, AGAA_MERGE_RULE);
    agaa_keptCount = 0u;
    uint fragment = agaa_sortList(pixel);
    while (fragment != 0u) {
        uint record = agaa_record(fragment);
        agaa_insertFragment(pixel, record, rules);
        fragment = agaa_fragments.words[record + 1u];
    }
    for (uint a = 0u; a < agaa_aggregateLimit(); ++a)
        agaa_storeSurface(agaa_surfaceBase(pixel, a), a);
}

// Whether this draw kept all fragments of the group's tile.
bool agaa_isTilesTurn() {
    if (!agaa_hasBatches())
        return true;
    uint batch = agaa_fragments.words[AGAA_LIST_BATCH];
    if (agaa_fragments.words[AGAA_LIST_BATCHES] == 1u)
        return batch == 0u;
    return batch != 0u && agaa_fragments.words[agaa_tileOf(gl_WorkGroupID.xy * 8u, agaa_frame.size.xy)] == batch;
}

// Whether anything is left for this draw.
bool agaa_isDrawNeeded() {
    uint batch = agaa_fragments.words[AGAA_LIST_BATCH];
    return batch == 0u || batch < agaa_fragments.words[AGAA_LIST_BATCHES];
}

void main() {
    agaa_countBegin();
    if (gl_WorkGroupID.xy == uvec2(0u) && gl_LocalInvocationIndex == 0u && agaa_isDrawNeeded())
        agaa_count(AGAA_COUNT_BATCHES, 1u);
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool isInside = all(lessThan(pixel, agaa_frame.size.xy));
    bool turn = agaa_isTilesTurn();
    if (isInside && turn)
        agaa_mergePixel(pixel);
    else if (isInside && agaa_fragments.words[AGAA_LIST_BATCH] == 0u)
        agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size.xy)] = 0u; // a further draw makes the list anew
    agaa_countEnd();
}
