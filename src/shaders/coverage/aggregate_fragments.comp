// Aggregates of the fragments that a pixel shows, each shaded once: clustering (AGAA section 3.3) over visibility at
// coverage samples, which Wang et al. (I3D 2016) name as future work.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_LISTS_QUALIFIER coherent
#define AGAA_SHOWN uint // the first fragment of the list
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#define AGAA_MAX_EVENTS AGAA_AGGREGATES
#include "common/tile.glsl"
#include "coverage/fragment_groups.glsl"
#include "ids/fetched_means.glsl"

shared uint agaa_heads[64];                     // of each pixel's list
shared uvec4 agaa_masks[64u * AGAA_AGGREGATES]; // samples of each aggregate

agaa_PixelWork agaa_workOf(uvec2 pixel) {
    const uint lane = gl_LocalInvocationIndex;
    uint head = agaa_resolveList(pixel);
    uint count = agaa_groupFragments(pixel, head);
    agaa_heads[lane] = head;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
        agaa_masks[lane * AGAA_AGGREGATES + a] = uvec4(0u);
    uint covered = 0u;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        agaa_masks[lane * AGAA_AGGREGATES + agaa_aggregateOf(record)] |= mask;
        covered += agaa_coverageCount(mask);
        fragment = agaa_nextOf(record);
    }
    memoryBarrierBuffer(); // other lanes shade what this one grouped
    agaa_countEvents(count);
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_pixelWork((1u << count) - 1u, 0u, covered);
}

#if AGAA_LIT
float agaa_sampleLight[AGAA_SAMPLES]; // share of a shadow's light that each sample gets, of the aggregate at hand
#endif

float agaa_weightOf(uint i, bool isLit) {
#if AGAA_LIT
    if (isLit)
        return agaa_sampleLight[i];
#endif
    return 1.0;
}

agaa_Places agaa_placesOf(uvec4 mask, float scale, bool isLit) {
    agaa_Places p = agaa_Places(0.0, vec2(0.0), vec3(0.0));
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        for (uint left = mask[word]; left != 0u; left &= left - 1u) {
            uint i = word * 32u + uint(findLSB(left));
            float weight = scale * agaa_weightOf(i, isLit);
            vec2 place = agaa_coveragePosition(i, AGAA_SAMPLES) + 0.5;
            p.weight += weight;
            p.sum += weight * place;
            p.products += weight * vec3(place * place, place.x * place.y);
        }
    return p;
}

// Means over the fragments of aggregate a, whose samples weigh scale, times the light that they get where isLit is set.
agaa_Means agaa_meansOf(uvec2 pixel, uint head, uint a, float scale, bool isLit) {
    agaa_Means means = agaa_noMeans();
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        uint count = agaa_coverageCount(mask);
        if (agaa_aggregateOf(record) == a && count != 0u) {
            AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
            AgaaMaterial m = agaa_fetchCovered(p, pixel, agaa_coverageMiddle(mask, AGAA_SAMPLES));
            bool isWeighed = isLit || agaa_isCurvedMaterial(m);
            agaa_Places places = agaa_placesOf(isWeighed ? mask : uvec4(0u), scale, isLit);
            agaa_addFetched(means, m, isWeighed ? places.weight : scale * float(count), places);
        }
        fragment = agaa_nextOf(record);
    }
    return means;
}

// Mean position of the aggregate's samples, in shading space.
vec3 agaa_placeFragments(uvec2 pixel, uint head, uint a, float weight) {
    vec3 first = vec3(0.0);
    vec3 away = vec3(0.0); // from the first: sums keep their digits (hard case 14)
    bool isFirst = true;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uvec4 mask = agaa_maskOf(record);
        uint count = agaa_coverageCount(mask);
        if (agaa_aggregateOf(record) == a && count != 0u) {
            vec3 position = agaa_surfacePosition(pixel, agaa_keptPlane(record), agaa_coverageMiddle(mask, AGAA_SAMPLES));
            first = isFirst ? position : first;
            isFirst = false;
            away += (position - first) * float(count);
        }
        fragment = agaa_nextOf(record);
    }
    return first + away / weight;
}

// The plane of the fragment that shows at a sample.
vec3 agaa_shownPlane(uint head, uint sampleOf) {
    vec3 plane = vec3(0.0);
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        bool isFound = (agaa_maskOf(record)[sampleOf / 32u] >> (sampleOf & 31u) & 1u) != 0u;
        plane = isFound ? agaa_keptPlane(record) : plane;
        fragment = isFound ? 0u : agaa_nextOf(record);
    }
    return plane;
}

#if AGAA_LIT
// Of each key light's shadow, the share of the samples that its light reaches and the means over what it reaches.
void agaa_findLitSurfaces(uvec2 pixel, uint head, uint a, float weight, vec3 toEye) {
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map) {
        if (!agaa_isLitShadow(map))
            continue;
        float sum = 0.0;
        for (uint fragment = head; fragment != 0u;) {
            uint record = agaa_record(fragment);
            uvec4 mask = agaa_aggregateOf(record) == a ? agaa_maskOf(record) : uvec4(0u);
            vec3 plane = agaa_keptPlane(record);
            for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
                for (uint left = mask[word]; left != 0u; left &= left - 1u) {
                    uint i = word * 32u + uint(findLSB(left));
                    vec2 at = agaa_coveragePosition(i, AGAA_SAMPLES);
                    agaa_sampleLight[i] = agaa_shadowTap(map, agaa_surfacePosition(pixel, plane, at));
                    sum += agaa_sampleLight[i];
                }
            fragment = agaa_nextOf(record);
        }
        agaa_visibility[map] = sum / weight;
        agaa_Means means = agaa_meansOf(pixel, head, a, sum > 1e-6 ? 1.0 / sum : 0.0, true);
        agaa_litSurface[map] = agaa_surfaceOfMeans(means, false, toEye);
    }
}
#endif

vec3 agaa_shadeEvent(uint lane, uint a) {
    uvec2 pixel = agaa_pixelOf(lane);
    uint head = agaa_heads[lane];
    uvec4 mask = agaa_masks[lane * AGAA_AGGREGATES + a];
    float weight = float(agaa_coverageCount(mask));
    vec3 position = agaa_placeFragments(pixel, head, a, weight);
    agaa_tapSurface(pixel, head, mask, position);
    agaa_Means means = agaa_meansOf(pixel, head, a, 1.0 / weight, false);
    vec3 toEye = agaa_toEye(position);
    agaa_Surface s = agaa_surfaceOfMeans(means, false, toEye);
    agaa_countWidening(means, s);
#if AGAA_LIT
    agaa_findLitSurfaces(pixel, head, a, weight, toEye);
#endif
    vec3 color = agaa_showsEvents() ? agaa_shownOfEvent(a, agaa_widening(means, s), s.diffuse) : agaa_lightSurface(s, position);
    return color * weight;
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
