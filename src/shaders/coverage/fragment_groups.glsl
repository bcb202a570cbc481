// Which of a pixel's fragments are shaded together (AGAA section 3.3): fragments are clustered as samples are, each at the
// middle of the samples that show it.
#ifndef AGAA_FRAGMENT_GROUPS_GLSL
#define AGAA_FRAGMENT_GROUPS_GLSL
#define AGAA_MAX_SAMPLES 33 // 32 that are clustered, and one at hand
#include "aggregate/grouping.glsl"
#include "coverage/shown_fragments.glsl"
#include "coverage/covered_place.glsl"

const uint agaa_mostClustered = 32u;
vec4 agaa_itemGloss[AGAA_MAX_SAMPLES];   // shading normal, alpha2; where AGAA_GLOSS_WEIGHT is set
uint agaa_itemFragment[AGAA_MAX_SAMPLES];

#define AGAA_AGGREGATE_OF_FRAGMENT (AGAA_PLANE_WORD + 3u)
void agaa_setAggregate(uint record, uint a) { agaa_fragments.words[record + AGAA_AGGREGATE_OF_FRAGMENT] = a; }
uint agaa_aggregateOf(uint record) { return agaa_fragments.words[record + AGAA_AGGREGATE_OF_FRAGMENT]; }

// As agaa_fetchMaterial() does of samples: the normal is that at the pixel's corner.
AgaaMaterial agaa_fetchCovered(AgaaPrimitive p, uvec2 pixel, vec2 middle) {
    agaa_moveTo(p, pixel, middle + 0.5);
    AgaaMaterial m = agaa_fetchMaterialThere(p);
    m.normal -= (middle.x + 0.5) * m.normalDx + (middle.y + 0.5) * m.normalDy;
    return m;
}

// Fragment as number i of those that are clustered.
void agaa_addFragment(inout agaa_PixelSamples samples, uvec2 pixel, uint i, uint fragment) {
    uint record = agaa_record(fragment);
    vec2 middle = agaa_coverageMiddle(agaa_maskOf(record), AGAA_SAMPLES);
    vec3 plane = agaa_keptPlane(record);
    float depth = agaa_deviceDepth(plane.x + dot(plane.yz, middle));
    AgaaPrimitive p = agaa_primitive(agaa_fragments.words[record]);
    vec3 normal = agaa_planeNormal(p);
    agaa_itemFragment[i] = fragment;
    agaa_addPlaced(samples, i, agaa_placeViewPosition(pixel, middle + 0.5, depth), depth, 2.4e-7 * depth, middle + 0.5, normal,
                   agaa_codeOfNormal(normal));
    if (AGAA_GLOSS_WEIGHT == 0u)
        return;
    AgaaMaterial m = agaa_fetchCovered(p, pixel, middle);
    vec3 n = m.normal + (middle.x + 0.5) * m.normalDx + (middle.y + 0.5) * m.normalDy;
    agaa_itemGloss[i] = vec4(n * inversesqrt(max(dot(n, n), 1e-6)), m.alpha2);
}

void agaa_weighItem(uint i) {
    agaa_weighNormal(i, mat3(agaa_frame.view) * agaa_itemGloss[i].xyz, agaa_itemGloss[i].w);
}

void agaa_weighNormals(uvec2 pixel, uint covered) {
    for (uint rest = covered; rest != 0u; rest &= rest - 1u)
        agaa_weighItem(uint(findLSB(rest)));
}

bool agaa_agreeShadingNormals(uvec2 pixel, uint covered) {
    if (AGAA_GLOSS_WEIGHT == 0u)
        return true; // planes decide
    vec3 normal = agaa_itemGloss[findLSB(covered)].xyz;
    float least = 1.0;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u)
        least = min(least, dot(normal, agaa_itemGloss[findLSB(rest)].xyz));
    return least >= agaa_frame.surface.x;
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

// Adds the fragments that show at most samples, of equals the first, up to agaa_mostClustered. Returns their number.
uint agaa_addLargest(inout agaa_PixelSamples samples, uvec2 pixel, uint head, uint shown) {
    uint enough = 1u; // fragments of so many samples find room, all of them: 32 have 4 each of 128 at most
    while (enough < 4u && shown > agaa_mostClustered) {
        ++enough;
        shown = agaa_countShown(head, enough);
    }
    uint room = agaa_mostClustered - shown; // for smaller ones
    uint count = 0u;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uint bits = agaa_coverageCount(agaa_maskOf(record));
        bool isSmaller = bits + 1u == enough && bits != 0u && room != 0u;
        if ((bits >= enough || isSmaller) && count < agaa_mostClustered) {
            room -= isSmaller ? 1u : 0u;
            agaa_addFragment(samples, pixel, count, fragment);
            agaa_setAggregate(record, count);
            ++count;
        } else {
            agaa_setAggregate(record, agaa_mostClustered);
        }
        fragment = agaa_nextOf(record);
    }
    return count;
}

// The one of `count` aggregates whose seed is nearest to the fragment, which was not clustered.
uint agaa_nearestSeed(uvec2 pixel, uint fragment, uint count, agaa_Lengths lengths) {
    agaa_PixelSamples ignored = agaa_noSamples();
    agaa_addFragment(ignored, pixel, agaa_mostClustered, fragment);
    if (AGAA_GLOSS_WEIGHT != 0u)
        agaa_weighItem(agaa_mostClustered);
    uint best = 0u;
    float least = agaa_pairDistance(agaa_mostClustered, agaa_seedSample[0], lengths);
    for (uint a = 1u; a < count; ++a) {
        float d = agaa_pairDistance(agaa_mostClustered, agaa_seedSample[a], lengths);
        best = d < least ? a : best;
        least = min(d, least);
    }
    return best;
}

// Gives each fragment of the resolved list its aggregate, and returns how many aggregates there are.
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
    agaa_Lengths lengths = agaa_lengthsFor(agaa_pixelCharacteristicLength(samples), agaa_frame.cluster.z);
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uint item = agaa_aggregateOf(record);
        uint a = 0u;
        if (count > 1u && item < agaa_mostClustered)
            a = agaa_sampleAggregate[item];
        else if (count > 1u && agaa_coverageCount(agaa_maskOf(record)) != 0u)
            a = agaa_nearestSeed(pixel, fragment, count, lengths);
        agaa_setAggregate(record, a);
        fragment = agaa_nextOf(record);
    }
    return count;
}
#endif
