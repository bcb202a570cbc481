// Aggregates the fragments that a pixel shows and shades each aggregate once. This is the clustering of AGAA (section
// 3.3) over visibility at coverage samples, which Wang et al. (I3D 2016) name as future work. Each fragment is
// clustered as a sample at the centroid of the samples that show it. A lane has a pixel; with AGAA_SAMPLE_LANES,
// fragments are clustered with one lane per fragment.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_LISTS_QUALIFIER coherent
#define AGAA_SHOWN uint // head of the list
#define AGAA_FINDS_LIGHTS
#define AGAA_VISIBILITY_WORDS 32u
#if AGAA_SAMPLE_LANES
#define AGAA_SAMPLE_WORDS AGAA_VISIBILITY_WORDS
#define AGAA_VARIABLE_LANES
#define AGAA_MAX_SAMPLES 1
#else
#define AGAA_MAX_SAMPLES 33 // 32 clustered fragments and the current one
#endif
#define AGAA_ORDERS_PIXELS
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "common/event_light.glsl"
#include "common/events.glsl"
#include "common/tile_pixels.glsl"
#include "aggregate/pixel_samples.glsl"
#include "math/sbaa_surfaces.glsl"
#include "coverage/shown_fragments.glsl"
#include "coverage/surface_position.glsl"
#include "ids/fetched_means.glsl"
#include "coverage/clustered_fragments.glsl"
#include "coverage/listed_tiles.glsl"
#include "coverage/list_box.glsl"
#include "coverage/pixel_order.glsl"
#if AGAA_SAMPLE_LANES
#include "coverage/lane_fragments.glsl"
#else
#include "coverage/pixel_fragments.glsl"
#endif

shared uint agaa_heads[64]; // the first fragment of each pixel's list

// Finds the samples of the aggregates of this lane's pixel, and returns its work.
agaa_PixelWork agaa_workOfGroups(uint head, uint count) {
    const uint lane = gl_LocalInvocationIndex;
    agaa_heads[lane] = head;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
        agaa_setAggregateMask(lane, a, uvec4(0u));
    uint covered = 0u;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        uint samples = agaa_coverageCount(mask);
        if (samples != 0u) {
            uint a = agaa_aggregateOf(record);
            agaa_setAggregateMask(lane, a, agaa_aggregateMask(lane, a) | mask);
        }
        covered += samples;
        fragment = agaa_nextOf(record);
    }
    memoryBarrierBuffer(); // other lanes shade the fragments that this lane grouped
    agaa_countEvents(count);
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_pixelWork((1u << count) - 1u, 0u, covered);
}

agaa_PositionSums agaa_noPositions() { return agaa_PositionSums(0.0, vec2(0.0), vec3(0.0)); }

// offset   Of a sample from the pixel's centre.
void agaa_addPosition(inout agaa_PositionSums p, float weight, vec2 offset) {
    vec2 at = offset + 0.5;
    p.weight += weight;
    p.sum += weight * at;
    p.products += weight * vec3(at * at, at.x * at.y);
}

agaa_PositionSums agaa_positionSumsOf(uvec4 mask, float weight) {
    agaa_PositionSums p = agaa_noPositions();
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        for (uint left = mask[word]; left != 0u; left &= left - 1u)
            agaa_addPosition(p, weight, agaa_coveragePosition(word * 32u + uint(findLSB(left)), AGAA_SAMPLES));
    return p;
}

// Returns the mean position of the aggregate's samples in shading space.
vec3 agaa_meanFragmentPosition(uvec2 pixel, uint head, uint a, float weight) {
    vec3 first = vec3(0.0);
    vec3 away = vec3(0.0); // relative to the first, so that sums keep their digits (hard case 14)
    bool isFirst = true;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        uint count = agaa_coverageCount(mask);
        if (agaa_aggregateOf(record) == a && count != 0u) {
            vec3 position =
                agaa_surfacePosition(pixel, agaa_keptPlane(record), agaa_coverageMiddle(mask, AGAA_SAMPLES));
            first = isFirst ? position : first;
            isFirst = false;
            away += (position - first) * float(count);
        }
        fragment = agaa_nextOf(record);
    }
    return first + away / weight;
}

// Returns the plane of the fragment that shows at a sample.
agaa_DepthPlane agaa_shownPlane(uint head, uint sampleOf) {
    agaa_DepthPlane plane = agaa_DepthPlane(0.0, vec2(0.0), vec2(0.0));
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        bool isFound = (agaa_maskOf(record)[sampleOf / 32u] >> (sampleOf & 31u) & 1u) != 0u;
        if (isFound)
            plane = agaa_keptPlane(record);
        fragment = isFound ? 0u : agaa_nextOf(record);
    }
    return plane;
}

#if AGAA_LIT
// Returns sums over the samples of a fragment, each times `scale` and the share of the shadow's light that reaches it.
// isKnown  The function was called for these samples before.
// total    Receives the sum of the shares added to it.
agaa_PositionSums agaa_litPositions(uvec2 pixel, uint map, agaa_DepthPlane plane, uvec4 mask, float scale, bool isKnown,
                                    inout float total) {
    agaa_PositionSums p = agaa_noPositions();
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        for (uint left = mask[word]; left != 0u; left &= left - 1u) {
            uint i = word * 32u + uint(findLSB(left));
            vec2 at = agaa_coveragePosition(i, AGAA_SAMPLES);
            float light = agaa_lightOfSample(pixel, map, plane, i, at, isKnown);
            total += light;
            agaa_addPosition(p, scale * light, at);
        }
    return p;
}
const uint agaa_maxParts = 1u + 2u * AGAA_SHADOW_MAPS;
#else
const uint agaa_maxParts = 1u;
#endif

// Returns the surface of aggregate a. Finds, for the shadow of each key light, the share of the samples that the light
// reaches and the surface of this part. Each shadow has two iterations: the first one adds up the light, and the second
// one finds the surface. One loop is over all of these, so that compilers do not repeat its code.
// widening   Receives agaa_widening() of the whole surface.
agaa_Surface agaa_findSurfaces(uvec2 pixel, uint head, uint a, float weight, vec3 toEye, out float widening) {
    agaa_Surface whole;
    widening = 0.0;
    float scale = 1.0 / weight;
    float light = 0.0;
    uint part = 0u;
    do {
        const bool isLit = part != 0u;
        const bool findsLight = (part & 1u) != 0u;
        const uint map = (part - 1u) / 2u;
        if (isLit && !agaa_isLitShadow(map))
            continue;
        float total = 0.0;
        agaa_Means means = agaa_noMeans();
        for (uint fragment = head; fragment != 0u;) {
            uint record = agaa_record(fragment);
            uvec4 mask = agaa_maskOf(record);
            uint count = agaa_coverageCount(mask);
            if (agaa_aggregateOf(record) == a && count != 0u) {
                agaa_PositionSums sums = agaa_noPositions();
#if AGAA_LIT
                if (isLit)
                    sums = agaa_litPositions(pixel, map, agaa_keptPlane(record), mask, scale, !findsLight, total);
#endif
                if (!findsLight) {
                    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
                    AgaaMaterial m = agaa_fetchCovered(p, pixel, agaa_coverageMiddle(mask, AGAA_SAMPLES));
                    if (!isLit && agaa_isCurvedMaterial(m))
                        sums = agaa_positionSumsOf(mask, scale);
                    else if (!isLit)
                        sums.weight = scale * float(count);
                    agaa_addFetched(means, m, sums.weight, sums);
                }
            }
            fragment = agaa_nextOf(record);
        }
        if (findsLight) {
            light = total;
            scale = light > 1e-6 ? 1.0 / light : 0.0;
            continue;
        }
        agaa_Surface s = agaa_surfaceOfMeans(means, false, toEye);
        if (!isLit) {
            whole = s;
            agaa_setEventMeans(means);
            widening = agaa_widening(means, s);
            agaa_countWidening(means, s);
        }
#if AGAA_LIT
        else {
            agaa_setLitSurface(map, light / weight, s);
        }
#endif
    } while (++part < agaa_maxParts);
    return whole;
}

vec3 agaa_shadeEvent(uint lane, uint a) {
    uvec2 pixel = agaa_pixelOf(lane);
    agaa_lightPixel(pixel);
    uint head = agaa_heads[lane];
    uvec4 mask = agaa_aggregateMask(lane, a);
    float weight = float(agaa_coverageCount(mask));
    vec3 position = agaa_meanFragmentPosition(pixel, head, a, weight);
    agaa_tapSurface(pixel, head, mask, position);
    float widening;
    agaa_Surface s = agaa_findSurfaces(pixel, head, a, weight, agaa_toEye(position), widening);
    return agaa_eventLight(a, widening, s, position) * weight;
}

void main() {
    agaa_countBegin();
    agaa_countDraw();
    bool isListed = agaa_isTileListed(); // equal for all lanes
    agaa_orderPixels(isListed);
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool inside = all(lessThan(pixel, agaa_frame.size));
    if (!isListed) {
        if (inside)
            agaa_awaitDraw(pixel);
        agaa_countEnd();
        return;
    }
    uint head = 0u;
    uint shown = 0u;
    agaa_beginTileLights();
    if (inside) {
        head = agaa_resolveList(pixel);
        agaa_addToTile(agaa_boxOfList(pixel, head));
        shown = agaa_countShown(head, 1u);
        agaa_shownPrimitives = shown;
        agaa_count(AGAA_COUNT_PRIMITIVES, shown);
    }
    agaa_findTileLights(); // agaa_shadeWork() has the barrier
    uint count = agaa_groupFragments(pixel, head, shown);
    agaa_PixelWork work = agaa_pixelWork(0u, 0u, 0u);
    if (inside)
        work = agaa_workOfGroups(head, count);
    vec3 color = agaa_shadeWork(work);
    if (inside)
        agaa_writePixel(pixel, work, color);
    agaa_countEnd();
}
