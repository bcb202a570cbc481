// Groups the fragments of a pixel with one lane per pixel (coverage/lane_fragments.glsl has one lane per fragment).
// Needs coverage/clustered_fragments.glsl.
#ifndef AGAA_PIXEL_FRAGMENTS_GLSL
#define AGAA_PIXEL_FRAGMENTS_GLSL
#ifndef AGAA_CLUSTERED_FRAGMENTS_GLSL
#error "pixel_fragments.glsl needs clustered_fragments.glsl."
#endif
#include "aggregate/grouping.glsl"

struct agaa_Gloss {
    vec3 normal; // for shading
    float alpha2;
};
agaa_Gloss agaa_itemGloss[AGAA_MAX_SAMPLES]; // where AGAA_GLOSS_WEIGHT is set
agaa_PixelSamples agaa_taken;                // the clustered fragments
// This precedes all readers, because compilers warn about reads that precede writes.
void agaa_takeNone() { agaa_taken = agaa_noSamples(); }

// Adds the fragment as number i of the clustered ones.
void agaa_takeFragment(uvec2 pixel, uint i, uint fragment) {
    agaa_FragmentSample s = agaa_sampleOfFragment(pixel, agaa_record(fragment));
    agaa_addSampleAt(agaa_taken, i, s.position, s.depth, agaa_fragmentQuantum(s.depth), s.offset, s.normal, s.code);
    if (AGAA_GLOSS_WEIGHT != 0u)
        agaa_itemGloss[i] = agaa_Gloss(s.shadingNormal, s.alpha2);
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

// Returns the aggregate, of `count`, whose seed is nearest to a fragment that was not clustered.
uint agaa_nearestSeed(uvec2 pixel, uint fragment, uint count, agaa_Lengths lengths) {
    agaa_takeFragment(pixel, agaa_maxClustered, fragment);
    if (AGAA_GLOSS_WEIGHT != 0u)
        agaa_weighItem(agaa_maxClustered);
    agaa_NearestSeed nearest = agaa_noSeed();
    for (uint a = 0u; a < count; ++a) {
        uint seed = agaa_seedSample[a];
        agaa_compareSeed(nearest, a, agaa_pairDistance(agaa_maxClustered, seed, lengths),
                         agaa_sampleKeyB[agaa_maxClustered], agaa_sampleKeyB[seed]);
    }
    return agaa_countedSeed(nearest);
}

// Assigns each fragment of the resolved list to an aggregate. Returns the number of aggregates.
// shown   Number of fragments that show at a sample.
uint agaa_groupFragments(uvec2 pixel, uint head, uint shown) {
    if (!agaa_groupsFragments(shown)) {
        agaa_joinFragments(head);
        return min(shown, 1u);
    }
    agaa_takeNone();
    uint clustered = agaa_chooseLargest(pixel, head, shown);
    agaa_PixelSamples samples = agaa_withDistance(agaa_taken);
    uint count = agaa_groupSamples(pixel, samples, clustered);
    agaa_count(AGAA_COUNT_JOINED_CLASSES, uint(bitCount(agaa_joiningSamples)));
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

shared uvec4 agaa_masks[64u * AGAA_AGGREGATES];
uvec4 agaa_aggregateMask(uint lane, uint a) { return agaa_masks[lane * AGAA_AGGREGATES + a]; }
void agaa_setAggregateMask(uint lane, uint a, uvec4 mask) { agaa_masks[lane * AGAA_AGGREGATES + a] = mask; }

#if AGAA_LIT
float agaa_sampleLight[AGAA_SAMPLES];

// Returns the share of a shadow's light that reaches sample i of a plane.
// at        Its position from the pixel's centre.
// isKnown   The function was called for the sample before.
float agaa_lightOfSample(uvec2 pixel, uint map, agaa_DepthPlane plane, uint i, vec2 at, bool isKnown) {
    if (!isKnown)
        agaa_sampleLight[i] = agaa_shadowTap(map, agaa_surfacePosition(pixel, plane, at));
    return agaa_sampleLight[i];
}
#endif
#endif
