// Fetches materials for the id tiers. The lanes of a workgroup collect the distinct primitives of 64 pixels and fetch
// one material per entry, at the centroid of its samples. They also share the grouping of samples in pixels with
// several primitives: ids/pixel_grouping.glsl has one lane per pixel, ids/lane_grouping.glsl one per sample. Needs
// AGAA_MAX_SAMPLES, common/target.glsl and what ids/fetch.glsl needs.
#ifndef AGAA_PRIMITIVES_GLSL
#define AGAA_PRIMITIVES_GLSL
#if !defined(AGAA_MAX_SAMPLES) || !defined(AGAA_HOST_FETCH)
#error "primitives.glsl needs AGAA_MAX_SAMPLES and AGAA_HOST_FETCH."
#endif
#include "aggregate/samples.glsl"
#include "common/debug_view.glsl"
#include "ids/fetched_custom.glsl"
#include "ids/primitive_list.glsl"
#include "math/sbaa_surfaces.glsl"

shared uint agaa_complexCount;  // number of pixels whose samples are grouped
shared uint agaa_masks[64u * AGAA_AGGREGATES]; // samples of each aggregate
shared uint agaa_waitingCount;                 // number of pixels for which the list had no room
#ifdef AGAA_SOME_UNFETCHED
shared uint agaa_uncoveredSamples[64]; // of each pixel: samples that the G-buffer of unfetched draws lacks
#endif

vec3 agaa_listedNormal(uint at, uint i) { return agaa_materialNormal(agaa_listMaterial[at], i); }

// Returns the code of a sample's content, of agaa_codeWithClass().
// plane   Normal of the entry's plane.
uint agaa_listedCode(uint at, vec3 plane) {
    return agaa_codeWithClass(agaa_codeOfNormal(plane), agaa_classOfMaterial(agaa_listMaterial[at]), 1u);
}

uint agaa_loadIds(uvec2 pixel);
uint agaa_findEntry(uvec2 pixel, uint left, out uint ofPrimitive);

#if AGAA_SAMPLE_LANES
#include "ids/lane_grouping.glsl"
#else
#include "ids/pixel_grouping.glsl"
#endif

// Loads the ids of a pixel's samples. Returns the mask of samples with geometry.
uint agaa_loadIds(uvec2 pixel) {
    uint covered = 0u;
    agaa_shownUnfetched = false;
    uint i = 0u;
    do {
        uint id = agaa_idOf(pixel, i);
        agaa_keepId(i, id);
        covered |= id != 0u ? 1u << i : 0u;
        agaa_shownUnfetched = agaa_shownUnfetched || !agaa_isFetched(id);
    } while (++i < agaa_sampleCount());
    return covered;
}

#ifdef AGAA_SOME_UNFETCHED
// Returns the samples of `left` that equal its first sample `first`. With an entry per sample, a pixel would have up to
// n entries, and a workgroup would need as many iterations.
uint agaa_alikeUnfetched(uvec2 pixel, uint first, uint left) {
    uint end = min((first / AGAA_HW_SAMPLES + 1u) * AGAA_HW_SAMPLES, agaa_sampleCount());
    uint alike = 1u << first;
    for (uint i = first + 1u; i < end; ++i)
        if ((left >> i & 1u) != 0u && !agaa_isFetched(agaa_keptId(i)) && agaa_areAlike(pixel, first, i))
            alike |= 1u << i;
    return alike;
}
#else
uint agaa_alikeUnfetched(uvec2 pixel, uint first, uint left) { return 1u << first; }
#endif

// Returns the samples of the entry that has the first sample of `left`.
// ofPrimitive   Receives all samples of its primitive; 0 for unfetched draws.
uint agaa_findEntry(uvec2 pixel, uint left, out uint ofPrimitive) {
    uint first = uint(findLSB(left));
    uint id = agaa_keptId(first);
    ofPrimitive = 0u;
    if (!agaa_isFetched(id))
        return agaa_alikeUnfetched(pixel, first, left);
    uint i = 0u;
    do
        ofPrimitive |= agaa_keptId(i) == id ? 1u << i : 0u;
    while (++i < agaa_sampleCount());
    return ofPrimitive & left & agaa_materialGroup(first);
}

// Returns the number of list entries of these samples: one for each primitive and group of samples that share a
// material, and one for each set of equal samples of unfetched draws. shown receives the number of fetched primitives.
uint agaa_findPrimitives(uvec2 pixel, uint covered, out uint shown) {
    uint count = 0u;
    shown = 0u;
    for (uint left = covered; left != 0u; ++count) {
        uint ofPrimitive;
        uint samples = agaa_findEntry(pixel, left, ofPrimitive);
        shown += ofPrimitive != 0u && (ofPrimitive & covered & ~left) == 0u ? 1u : 0u;
        agaa_keepEntry(count, samples);
        left &= ~samples;
    }
    return count;
}

// Writes the entries of this lane's pixel. count: one or more.
void agaa_listPrimitives(uvec2 pixel, uint covered, uint first, uint count) {
    const uint lane = gl_LocalInvocationIndex;
    uint left = covered;
    uint i = 0u;
    do {
        uint samples = agaa_entryAgain(pixel, i, left);
        AGAA_LIST_ID(first + i) = agaa_keptId(uint(findLSB(samples)));
        agaa_listSamples[first + i] = samples;
        AGAA_LIST_LANE(first + i) = lane;
        left &= ~samples;
    } while (++i < count);
    agaa_pixelList[lane] = first | count << 16u | 1u << 24u;
}

void agaa_fetchListed(uint at) {
    uint samples = agaa_listSamples[at];
    uint lane = AGAA_LIST_LANE(at);
    uvec2 pixel = agaa_pixelOf(lane);
#ifdef AGAA_SOME_UNFETCHED
    if (!agaa_isFetched(AGAA_LIST_ID(at))) {
        if (!agaa_fetchSample(pixel, uint(findLSB(samples)))) {
            agaa_listSamples[at] = 0u;
            atomicOr(agaa_uncoveredSamples[lane], samples);
            return;
        }
        agaa_Surface s = agaa_sampleSurface();
        agaa_listPlane(at, mat3(agaa_frame.view) * s.normal);
        AgaaMaterial m = agaa_defaultMaterial();
        m.diffuse = s.diffuse;
        m.specular = s.specular;
        m.emissive = s.emissive;
        m.normal = s.normal;
        m.alpha2 = s.alpha2;
        AGAA_LOAD_CUSTOM(agaa_fetched, m)
        agaa_listMaterial[at] = m;
        return;
    }
#endif
    AgaaPrimitive p = agaa_primitive(AGAA_LIST_ID(at));
    agaa_listPlane(at, agaa_planeNormal(p));
    agaa_listMaterial[at] = agaa_fetchMaterial(p, pixel, samples);
}

// The includer defines this function. All lanes call it when the aggregates of their pixels are in agaa_masks.
// hasPixel    The lane has a pixel.
// covered     Samples with a material.
// uncovered   Samples with geometry that have no material.
void agaa_shadeDeferredPixel(bool hasPixel, uvec2 pixel, uint covered, uint uncovered);

// Calls agaa_shadeDeferredPixel() once for each pixel with geometry. All lanes must call it, with covered = 0 without a
// pixel.
void agaa_processPixels(uvec2 pixel, uint covered) {
    const uint lane = gl_LocalInvocationIndex;
    uint primitives = agaa_findPrimitives(pixel, covered, agaa_shownPrimitives);
    agaa_count(AGAA_COUNT_PRIMITIVES, agaa_shownPrimitives);
    bool isWaiting = covered != 0u;
    for (;;) {
        if (lane == 0u)
            agaa_listedCount = agaa_waitingCount = agaa_complexCount = 0u;
        for (uint at = lane; at < agaa_listLength; at += 64u)
            agaa_listSamples[at] = 0u;
        barrier();
        uint first = isWaiting ? atomicAdd(agaa_listedCount, primitives) : 0u;
        bool isListed = isWaiting && first + primitives <= agaa_listLength;
#ifdef AGAA_SOME_UNFETCHED
        agaa_uncoveredSamples[lane] = 0u;
#endif
        if (isListed) {
            agaa_listPrimitives(pixel, covered, first, primitives);
            for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
                agaa_masks[lane * AGAA_AGGREGATES + a] = a == 0u ? covered : 0u;
        }
        bool groups = isListed && AGAA_AGGREGATES > 1u &&
                      (primitives > 1u || agaa_splitsSurfaces() || AGAA_GLOSS_WEIGHT != 0u);
        if (groups)
            AGAA_COMPLEX_LANE(atomicAdd(agaa_complexCount, 1u)) = lane;
        isWaiting = isWaiting && !isListed;
        if (isWaiting)
            atomicAdd(agaa_waitingCount, 1u);
        barrier();
        uint listed = min(agaa_listedCount, agaa_listLength);
        uint waiting = agaa_waitingCount;
        uint at = lane;
        do {
            if (at < listed && agaa_listSamples[min(at, agaa_listLength - 1u)] != 0u)
                agaa_fetchListed(at);
            at += 64u;
        } while (at < listed);
        barrier();
#ifdef AGAA_SOME_UNFETCHED
        uint uncovered = isListed ? agaa_uncoveredSamples[lane] : 0u;
        if (isListed && !groups) { // agaa_groupComplexPixels() excludes them
            agaa_masks[lane * AGAA_AGGREGATES] &= ~uncovered;
            agaa_setAggregates(lane, covered == uncovered ? 0u : 1u);
        }
#else
        const uint uncovered = 0u;
#endif
        agaa_groupComplexPixels();
        barrier();
        agaa_shadeDeferredPixel(isListed, pixel, covered & ~uncovered, uncovered);
        if (waiting == 0u)
            break;
        agaa_keepIdsAgain(pixel, isWaiting);
        barrier();
    }
}
#endif
