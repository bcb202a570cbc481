// Aggregates the fragments that a pixel shows and shades each aggregate once. This is the clustering of AGAA (section
// 3.3) over visibility at coverage samples, which Wang et al. (I3D 2016) name as future work. Each fragment is
// clustered as a sample at the centroid of the samples that show it.
#version 450
#extension GL_GOOGLE_include_directive : require
#define AGAA_LISTS_QUALIFIER coherent
#define AGAA_SHOWN uint // head of the list
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
#define AGAA_MAX_SAMPLES 33 // 32 clustered fragments and the current one
#include "aggregate/grouping.glsl"
#include "coverage/shown_fragments.glsl"
#include "coverage/surface_position.glsl"
#include "ids/fetched_means.glsl"

const uint agaa_maxClustered = 32u;
struct agaa_Gloss {
    vec3 normal; // for shading
    float alpha2;
};
agaa_Gloss agaa_itemGloss[AGAA_MAX_SAMPLES]; // where AGAA_GLOSS_WEIGHT is set
uint agaa_itemFragment[AGAA_MAX_SAMPLES];

#define AGAA_AGGREGATE_OF_FRAGMENT (AGAA_PAYLOAD_AT + AGAA_KEPT_PLANE_WORDS)
void agaa_setAggregate(uint record, uint a) { agaa_fragments.words[record + AGAA_AGGREGATE_OF_FRAGMENT] = a; }
uint agaa_aggregateOf(uint record) { return agaa_fragments.words[record + AGAA_AGGREGATE_OF_FRAGMENT]; }

// Returns the material at an offset from the pixel's centre. Its normal is that at the pixel's corner.
AgaaMaterial agaa_fetchCovered(AgaaPrimitive p, uvec2 pixel, vec2 middle) {
    agaa_evaluateAt(p, pixel, middle + 0.5);
    AgaaMaterial m = agaa_evaluateMaterial(p);
    m.normal -= (middle.x + 0.5) * m.normalDx + (middle.y + 0.5) * m.normalDy;
    return m;
}

// Adds the fragment as number i of the clustered ones.
void agaa_addFragment(inout agaa_PixelSamples samples, uvec2 pixel, uint i, uint fragment) {
    uint record = agaa_record(fragment);
    vec2 middle = agaa_coverageMiddle(agaa_maskOf(record), AGAA_SAMPLES);
    float depth = agaa_deviceDepth(agaa_depthAt(agaa_keptPlane(record), middle));
    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
    vec3 normal = agaa_planeNormal(p);
    agaa_itemFragment[i] = fragment;
    agaa_addSampleAt(samples, i, agaa_viewPositionAt(pixel, middle + 0.5, depth), depth, 2.4e-7 * depth, middle + 0.5,
                     normal, agaa_codeOfNormal(normal));
    if (AGAA_GLOSS_WEIGHT == 0u)
        return;
    AgaaMaterial m = agaa_fetchCovered(p, pixel, middle);
    vec3 n = m.normal + (middle.x + 0.5) * m.normalDx + (middle.y + 0.5) * m.normalDy;
    agaa_itemGloss[i] = agaa_Gloss(n * inversesqrt(max(dot(n, n), 1e-6)), m.alpha2);
}

void agaa_weighItem(uint i) {
    agaa_weighNormal(i, mat3(agaa_frame.view) * agaa_itemGloss[i].normal, agaa_itemGloss[i].alpha2);
}

void agaa_weighNormals(uvec2 pixel, uint covered) {
    for (uint rest = covered; rest != 0u; rest &= rest - 1u)
        agaa_weighItem(uint(findLSB(rest)));
}

bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered) {
    if (AGAA_GLOSS_WEIGHT == 0u)
        return true; // planes are compared only
    vec3 normal = agaa_itemGloss[findLSB(covered)].normal;
    float least = 1.0;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u)
        least = min(least, dot(normal, agaa_itemGloss[findLSB(rest)].normal));
    return least >= agaa_frame.surfaceCosine;
}

uint agaa_countShown(uint head, uint least) {
    uint count = 0u;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        count += agaa_coverageCount(agaa_maskOf(record)) >= least ? 1u : 0u;
        fragment = agaa_nextOf(record);
    }
    return count;
}

// Adds up to agaa_maxClustered fragments, those with the most visible samples. Among fragments with equally many, it
// takes evenly spaced ones, so that near and far ones are represented. Returns their number.
uint agaa_addLargest(inout agaa_PixelSamples samples, uvec2 pixel, uint head, uint shown) {
    // All fragments with this number of samples have room: at most 32 fragments have 4 of 128 samples.
    uint enough = 1u;
    uint smaller = 0u; // fragments that show at one sample less
    while (enough < 4u && shown > agaa_maxClustered) {
        ++enough;
        smaller = shown;
        shown = agaa_countShown(head, enough);
        smaller -= shown;
    }
    uint room = agaa_maxClustered - shown; // for smaller fragments
    uint passed = 0u;
    uint count = 0u;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uint bits = agaa_coverageCount(agaa_maskOf(record));
        bool isSmaller = bits + 1u == enough && bits != 0u;
        bool isTaken = isSmaller && (passed + 1u) * room / smaller > passed * room / smaller;
        passed += isSmaller ? 1u : 0u;
        if ((bits >= enough || isTaken) && count < agaa_maxClustered) {
            agaa_addFragment(samples, pixel, count, fragment);
            agaa_setAggregate(record, count);
            ++count;
        } else {
            agaa_setAggregate(record, agaa_maxClustered);
        }
        fragment = agaa_nextOf(record);
    }
    return count;
}

// Returns the aggregate, of `count`, whose seed is nearest to a fragment that was not clustered.
uint agaa_nearestSeed(uvec2 pixel, uint fragment, uint count, agaa_Lengths lengths) {
    agaa_PixelSamples ignored = agaa_noSamples();
    agaa_addFragment(ignored, pixel, agaa_maxClustered, fragment);
    if (AGAA_GLOSS_WEIGHT != 0u)
        agaa_weighItem(agaa_maxClustered);
    uint best = 0u;
    float least = agaa_pairDistance(agaa_maxClustered, agaa_seedSample[0], lengths);
    for (uint a = 1u; a < count; ++a) {
        float d = agaa_pairDistance(agaa_maxClustered, agaa_seedSample[a], lengths);
        best = d < least ? a : best;
        least = min(d, least);
    }
    return best;
}

// Assigns each fragment of the resolved list to an aggregate. Returns the number of aggregates.
uint agaa_groupFragments(uvec2 pixel, uint head) {
    uint shown = agaa_countShown(head, 1u);
    agaa_shownPrimitives = shown;
    agaa_count(AGAA_COUNT_PRIMITIVES, shown);
    if (shown == 0u)
        return 0u;
    agaa_PixelSamples samples = agaa_noSamples();
    uint clustered = agaa_addLargest(samples, pixel, head, shown);
    samples = agaa_withDistance(samples);
    uint count = agaa_groupSamples(pixel, samples, clustered);
    agaa_Lengths lengths = agaa_lengthsFor(agaa_pixelCharacteristicLength(samples), agaa_frame.aggregateThreshold);
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uint item = agaa_aggregateOf(record);
        uint a = 0u;
        if (count > 1u && item < agaa_maxClustered)
            a = agaa_sampleAggregate[item];
        else if (count > 1u && agaa_coverageCount(agaa_maskOf(record)) != 0u)
            a = agaa_nearestSeed(pixel, fragment, count, lengths);
        agaa_setAggregate(record, a);
        fragment = agaa_nextOf(record);
    }
    return count;
}

shared uint agaa_heads[64];                     // the first fragment of each pixel's list
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
    memoryBarrierBuffer(); // other lanes shade the fragments that this lane grouped
    agaa_countEvents(count);
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_count(AGAA_COUNT_AGGREGATES, count);
    agaa_count(AGAA_COUNT_PIXELS, min(count, 1u));
    return agaa_pixelWork((1u << count) - 1u, 0u, covered);
}

#if AGAA_LIT
float agaa_sampleLight[AGAA_SAMPLES]; // share of a shadow's light that reaches each sample of the current aggregate
#endif

float agaa_weightOf(uint i, bool isLit) {
#if AGAA_LIT
    if (isLit)
        return agaa_sampleLight[i];
#endif
    return 1.0;
}

agaa_PositionSums agaa_positionSumsOf(uvec4 mask, float scale, bool isLit) {
    agaa_PositionSums p = agaa_PositionSums(0.0, vec2(0.0), vec3(0.0));
    for (uint word = 0u; word < AGAA_SAMPLES / 32u; ++word)
        for (uint left = mask[word]; left != 0u; left &= left - 1u) {
            uint i = word * 32u + uint(findLSB(left));
            float weight = scale * agaa_weightOf(i, isLit);
            vec2 at = agaa_coveragePosition(i, AGAA_SAMPLES) + 0.5;
            p.weight += weight;
            p.sum += weight * at;
            p.products += weight * vec3(at * at, at.x * at.y);
        }
    return p;
}

// Returns means over the fragments of aggregate a. A sample has the weight `scale`, times its light if isLit is set.
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
            agaa_PositionSums sums = agaa_positionSumsOf(isWeighed ? mask : uvec4(0u), scale, isLit);
            agaa_addFetched(means, m, isWeighed ? sums.weight : scale * float(count), sums);
        }
        fragment = agaa_nextOf(record);
    }
    return means;
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
// Finds, for the shadow of each key light, the share of the samples that the light reaches and the means over these
// samples.
void agaa_findLitSurfaces(uvec2 pixel, uint head, uint a, float weight, vec3 toEye) {
    for (uint map = 0u; map < AGAA_SHADOW_MAPS; ++map) {
        if (!agaa_isLitShadow(map))
            continue;
        float sum = 0.0;
        for (uint fragment = head; fragment != 0u;) {
            uint record = agaa_record(fragment);
            uvec4 mask = agaa_aggregateOf(record) == a ? agaa_maskOf(record) : uvec4(0u);
            agaa_DepthPlane plane = agaa_keptPlane(record);
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
    vec3 position = agaa_meanFragmentPosition(pixel, head, a, weight);
    agaa_tapSurface(pixel, head, mask, position);
    agaa_Means means = agaa_meansOf(pixel, head, a, 1.0 / weight, false);
    vec3 toEye = agaa_toEye(position);
    agaa_Surface s = agaa_surfaceOfMeans(means, false, toEye);
    agaa_countWidening(means, s);
#if AGAA_LIT
    agaa_findLitSurfaces(pixel, head, a, weight, toEye);
#endif
    vec3 color =
        agaa_showsEvents() ? agaa_shownOfEvent(a, agaa_widening(means, s), s.diffuse) : agaa_lightSurface(s, position);
    return color * weight;
}

void main() {
    agaa_countBegin();
    agaa_shadeTile();
    agaa_countEnd();
}
