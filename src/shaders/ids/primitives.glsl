// Primitives that the ids of 64 pixels name: lanes list them, and share out the fetching of materials, each in the
// middle of the samples that its primitive has in a pixel, and the grouping of samples in pixels of several.
#ifndef AGAA_PRIMITIVES_GLSL
#define AGAA_PRIMITIVES_GLSL
#include "aggregate/samples.glsl"
#include "aggregate/grouping.glsl"
#include "common/debug_view.glsl"

// Primitives of pixels that are in hand; a group with more takes them in turns, a pixel at a time at least.
#ifndef AGAA_LIST_LENGTH
#define AGAA_LIST_LENGTH 256u
#endif
const uint agaa_listLength = AGAA_LIST_LENGTH;
shared uint agaa_listedCount; // places asked for, of which some may not have been had
shared uint agaa_listId[agaa_listLength];
shared uint agaa_listSamples[agaa_listLength]; // 0: nobody's
shared uint agaa_listLane[agaa_listLength];
shared vec3 agaa_listPlane[agaa_listLength]; // normal in view space
shared AgaaMaterial agaa_listMaterial[agaa_listLength]; // its normal at the pixel's corner, not unit
shared uint agaa_pixelList[64];                    // first place | number of them << 16
shared uint agaa_complexCount;                        // pixels of several primitives
shared uint agaa_complexLanes[64];
shared uint agaa_aggregateCount[64];
shared uint agaa_masks[64u * AGAA_AGGREGATES];     // samples of each aggregate
shared uint agaa_waitingCount;                          // pixels that did not find room
#ifdef AGAA_SOME_UNFETCHED
shared uint agaa_uncoveredSamples[64]; // of each pixel, that the G-buffer of unfetched draws has not
#endif

// Of the pixel at hand.
uint agaa_sampleIds[AGAA_MAX_SAMPLES];
uint agaa_samplePrimitive[AGAA_MAX_SAMPLES]; // its place in the list
uint agaa_primitiveSamples[AGAA_MAX_SAMPLES];

// Returns the samples that show geometry.
uint agaa_loadIds(uvec2 pixel) {
    uint covered = 0u;
    agaa_shownUnfetched = false;
    uint i = 0u;
    do {
        uint id = agaa_idOf(pixel, i);
        agaa_sampleIds[i] = id;
        covered |= id != 0u ? 1u << i : 0u;
        agaa_shownUnfetched = agaa_shownUnfetched || !agaa_isFetched(id);
    } while (++i < agaa_sampleCount());
    return covered;
}

#ifdef AGAA_SOME_UNFETCHED
// Of `left`, the first of which is `first`, those that are alike: one by one a pixel would have up to n entries, and a
// group take its pixels in as many turns.
uint agaa_alikeUnfetched(uvec2 pixel, uint first, uint left) {
    uint end = min((first / AGAA_HW_SAMPLES + 1u) * AGAA_HW_SAMPLES, agaa_sampleCount());
    uint alike = 1u << first;
    for (uint i = first + 1u; i < end; ++i)
        if ((left >> i & 1u) != 0u && !agaa_isFetched(agaa_sampleIds[i]) && agaa_areAlike(pixel, first, i))
            alike |= 1u << i;
    return alike;
}
#else
uint agaa_alikeUnfetched(uvec2 pixel, uint first, uint left) { return 1u << first; }
#endif

// Returns how many entries these samples take: primitives, once for each group of samples that share a material, and of
// unfetched draws samples that are alike. shown: of fetched primitives.
uint agaa_findPrimitives(uvec2 pixel, uint covered, out uint shown) {
    uint count = 0u;
    shown = 0u;
    for (uint left = covered; left != 0u; ++count) {
        uint first = uint(findLSB(left));
        uint id = agaa_sampleIds[first];
        uint alike;
        if (!agaa_isFetched(id)) {
            alike = agaa_alikeUnfetched(pixel, first, left);
        } else {
            alike = left & (~left + 1u);
            uint i = 0u;
            do
                alike |= agaa_sampleIds[i] == id ? 1u << i : 0u;
            while (++i < agaa_sampleCount());
            shown += (alike & covered & ~left) == 0u ? 1u : 0u;
            alike &= left & agaa_materialGroup(first);
        }
        agaa_primitiveSamples[count] = alike;
        left &= ~alike;
    }
    return count;
}

// count: one or more.
void agaa_listPrimitives(uint first, uint count) {
    const uint lane = gl_LocalInvocationIndex;
    uint i = 0u;
    do {
        uint samples = agaa_primitiveSamples[i];
        agaa_listId[first + i] = agaa_sampleIds[findLSB(samples)];
        agaa_listSamples[first + i] = samples;
        agaa_listLane[first + i] = lane;
    } while (++i < count);
    agaa_pixelList[lane] = first | count << 16u;
}

void agaa_fetchListed(uint at) {
    uint samples = agaa_listSamples[at];
    uint lane = agaa_listLane[at];
    uvec2 pixel = agaa_pixelOf(lane);
#ifdef AGAA_SOME_UNFETCHED
    if (!agaa_isFetched(agaa_listId[at])) {
        if (!agaa_fetchSample(pixel, uint(findLSB(samples)))) {
            agaa_listSamples[at] = 0u;
            atomicOr(agaa_uncoveredSamples[lane], samples);
            return;
        }
        agaa_Surface s = agaa_sampleSurface();
        agaa_listPlane[at] = mat3(agaa_frame.view) * s.normal;
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
    AgaaPrimitive p = agaa_primitive(agaa_listId[at]);
    agaa_listPlane[at] = agaa_planeNormal(p);
    agaa_listMaterial[at] = agaa_fetchMaterial(p, pixel, samples);
}

vec3 agaa_listedNormal(uint at, uint i) { return agaa_materialNormal(agaa_listMaterial[at], i); }

// lane: of the pixel, which may be another's.
agaa_PixelSamples agaa_listedSamples(uvec2 pixel, uint lane) {
    agaa_PixelSamples samples = agaa_noSamples();
    uint first = agaa_pixelList[lane] & 0xFFFFu;
    uint count = agaa_pixelList[lane] >> 16u;
    uint covered = 0u;
    for (uint k = 0u; k < count; ++k) {
        covered |= agaa_listSamples[first + k];
        for (uint rest = agaa_listSamples[first + k]; rest != 0u; rest &= rest - 1u)
            agaa_samplePrimitive[findLSB(rest)] = first + k;
    }
    uint i = 0u;
    do {
        if ((covered >> i & 1u) != 0u) {
            vec3 normal = agaa_listPlane[agaa_samplePrimitive[i]];
            agaa_addSample(samples, pixel, i, normal, agaa_codeOfNormal(normal));
        }
    } while (++i < agaa_sampleCount());
    return agaa_withDistance(samples);
}

bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered) {
    if (AGAA_GLOSS_WEIGHT == 0u)
        return true; // planes decide
    uint first = uint(findLSB(covered));
    vec3 normal = agaa_listedNormal(agaa_samplePrimitive[first], first);
    float least = 1.0;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        least = min(least, dot(normal, agaa_listedNormal(agaa_samplePrimitive[i], i)));
    }
    return least >= agaa_frame.surfaceCosine;
}

void agaa_weighNormals(uvec2 pixel, uint covered) {
    uint i = 0u;
    do {
        if ((covered >> i & 1u) != 0u) {
            uint at = agaa_samplePrimitive[i];
            agaa_weighNormal(i, mat3(agaa_frame.view) * agaa_listedNormal(at, i), agaa_listMaterial[at].alpha2);
        }
    } while (++i < agaa_sampleCount());
}

// lane: of the pixel, which may be another's.
void agaa_groupListed(uint lane) {
    uvec2 pixel = agaa_pixelOf(lane);
    agaa_PixelSamples samples = agaa_listedSamples(pixel, lane);
    uint count = agaa_groupSamples(pixel, samples, agaa_sampleCount());
    agaa_aggregateCount[lane] = count;
    uint base = lane * AGAA_AGGREGATES;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
        agaa_masks[base + a] = a == 0u && count == 1u ? samples.covered : 0u;
    if (count > 1u)
        for (uint left = samples.covered; left != 0u; left &= left - 1u) {
            uint i = uint(findLSB(left));
            agaa_masks[base + agaa_sampleAggregate[i]] |= 1u << i;
        }
}

// Of the shader that includes this; called by all lanes.
// A pixel's aggregates are known, by agaa_masks; isHeld: the lane has one, all of whose samples are `covered` but for
// those that no geometry pass gave a material, `uncovered`.
void agaa_shadeDeferredPixel(bool isHeld, uvec2 pixel, uint covered, uint uncovered);

// Each pixel with geometry is taken once. Called by all lanes, `covered` being 0 of those that have no pixel.
void agaa_processPixels(uvec2 pixel, uint covered) {
    const uint lane = gl_LocalInvocationIndex;
    uint primitives = agaa_findPrimitives(pixel, covered, agaa_shownPrimitives);
    agaa_count(AGAA_COUNT_PRIMITIVES, agaa_shownPrimitives);
    bool waits = covered != 0u;
    for (;;) {
        if (lane == 0u)
            agaa_listedCount = agaa_waitingCount = agaa_complexCount = 0u;
        for (uint at = lane; at < agaa_listLength; at += 64u)
            agaa_listSamples[at] = 0u;
        barrier();
        uint first = waits ? atomicAdd(agaa_listedCount, primitives) : 0u;
        bool turn = waits && first + primitives <= agaa_listLength;
#ifdef AGAA_SOME_UNFETCHED
        agaa_uncoveredSamples[lane] = 0u;
#endif
        if (turn) {
            agaa_listPrimitives(first, primitives);
            agaa_aggregateCount[lane] = 1u;
            for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
                agaa_masks[lane * AGAA_AGGREGATES + a] = a == 0u ? covered : 0u;
        }
        bool groups = turn && AGAA_AGGREGATES > 1u &&
                      (primitives > 1u || agaa_splitsSurfaces() || AGAA_GLOSS_WEIGHT != 0u);
        if (groups)
            agaa_complexLanes[atomicAdd(agaa_complexCount, 1u)] = lane;
        waits = waits && !turn;
        if (waits)
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
        uint uncovered = turn ? agaa_uncoveredSamples[lane] : 0u;
        if (turn && !groups) { // grouping leaves them out by itself
            agaa_masks[lane * AGAA_AGGREGATES] &= ~uncovered;
            agaa_aggregateCount[lane] = covered == uncovered ? 0u : 1u;
        }
#else
        const uint uncovered = 0u;
#endif
        if (lane < agaa_complexCount) {
            agaa_groupListed(agaa_complexLanes[lane]);
        }
        barrier();
        agaa_shadeDeferredPixel(turn, pixel, covered & ~uncovered, uncovered);
        if (waiting == 0u)
            break;
        barrier();
    }
}
#endif
