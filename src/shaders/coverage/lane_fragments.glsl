// Groups the fragments of a tile's pixels with one lane per fragment (coverage/pixel_fragments.glsl has one lane per
// pixel). The results are equal bit for bit. A round processes as many pixels as have room in 64 lanes. All lanes of
// the workgroup call agaa_groupFragments(). Needs coverage/clustered_fragments.glsl and the words of lanes that
// coverage/list_visibility.glsl needs.
#ifndef AGAA_LANE_FRAGMENTS_GLSL
#define AGAA_LANE_FRAGMENTS_GLSL
#ifndef AGAA_CLUSTERED_FRAGMENTS_GLSL
#error "lane_fragments.glsl needs clustered_fragments.glsl."
#endif
#include "aggregate/lane_clustering.glsl"

// Words of a lane behind those of the clustering. The first two are of a lane's fragment, the others of its pixel.
#define AGAA_ENTRY_FRAGMENT(lane) AGAA_LANE_WORD(lane, AGAA_GROUPING_WORDS)
#define AGAA_ENTRY_PIXEL(lane) AGAA_LANE_WORD(lane, AGAA_GROUPING_WORDS + 1u) // its lane | first << 8 | entries << 16
#define AGAA_ENTRIES(lane) AGAA_LANE_WORD(lane, AGAA_GROUPING_WORDS + 2u)     // number of clustered fragments
#define AGAA_GROUP_COUNT(lane) AGAA_LANE_WORD(lane, AGAA_GROUPING_WORDS + 3u)
#define AGAA_GROUP_SEEDS(lane) AGAA_LANE_WORD(lane, AGAA_GROUPING_WORDS + 4u)
#define AGAA_GROUP_NEAREST(lane) AGAA_LANE_WORD(lane, AGAA_GROUPING_WORDS + 5u) // distance of the nearest fragment

// The aggregates' samples replace the other words after fragments are grouped.
const uint agaa_maskWords = AGAA_SAMPLES / 32u;
uvec4 agaa_aggregateMask(uint lane, uint a) {
    uvec4 mask = uvec4(0u);
    for (uint word = 0u; word < agaa_maskWords; ++word)
        mask[word] = AGAA_LANE_WORD(lane, a * agaa_maskWords + word);
    return mask;
}
void agaa_setAggregateMask(uint lane, uint a, uvec4 mask) {
    for (uint word = 0u; word < agaa_maskWords; ++word)
        AGAA_LANE_WORD(lane, a * agaa_maskWords + word) = mask[word];
}

void agaa_takeFragment(uvec2 pixel, uint item, uint fragment) {}

// The lanes of a pixel's fragments.
struct agaa_Entries {
    uint count;
    uint round;
    uint first;
    uint rounds; // of all pixels
};

// Assigns lanes to `count` fragments of this lane's pixel, up to agaa_maxClustered.
agaa_Entries agaa_placeEntries(uint count) {
    const uint lane = gl_LocalInvocationIndex;
    agaa_Entries entries = agaa_Entries(count, 0u, 0u, 0u);
    barrier(); // other lanes have words of their own until here
    AGAA_ENTRIES(lane) = count;
    barrier();
    uint first = 0u;
    uint round = 0u;
    for (uint i = 0u; i < 64u; ++i) {
        uint more = AGAA_ENTRIES(i);
        if (first + more > 64u) {
            ++round;
            first = 0u;
        }
        if (i == lane) {
            entries.round = round;
            entries.first = first;
        }
        first += more;
    }
    barrier(); // without rounds, lanes then write words of their own again
    entries.rounds = first != 0u ? round + 1u : 0u;
    return entries;
}

// Writes the clustered fragments of this lane's pixel to the words of their lanes.
void agaa_listEntries(uint head, agaa_Entries entries) {
    const uint lane = gl_LocalInvocationIndex;
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uint item = agaa_aggregateOf(record);
        if (item < agaa_maxClustered) {
            AGAA_ENTRY_FRAGMENT(entries.first + item) = fragment;
            AGAA_ENTRY_PIXEL(entries.first + item) = lane | entries.first << 8u | entries.count << 16u;
        }
        fragment = agaa_nextOf(record);
    }
}

agaa_LaneSample agaa_laneSampleOfFragment(uvec2 pixel, uint record) {
    agaa_FragmentSample f = agaa_sampleOfFragment(pixel, record);
    agaa_LaneSample s =
        agaa_laneSampleAt(f.position, f.depth, agaa_fragmentQuantum(f.depth), f.offset, f.normal, f.code);
    s.shadingNormal = f.shadingNormal;
    s.alpha2 = f.alpha2;
    return s;
}

// Groups the fragments of the lanes.
void agaa_groupEntries() {
    const uint lane = gl_LocalInvocationIndex;
    const uint entry = AGAA_ENTRY_PIXEL(lane);
    const bool hasFragment = entry != 0u;
    agaa_setLanes(hasFragment ? entry >> 8u & 0xFFu : lane, hasFragment ? entry >> 16u : 1u);
    agaa_LaneSample s = agaa_noLaneSample();
    const uint record = agaa_record(max(AGAA_ENTRY_FRAGMENT(lane), 1u));
    if (hasFragment)
        s = agaa_laneSampleOfFragment(agaa_pixelOf(entry & 0xFFu), record);
    agaa_LaneGroup group = agaa_groupLanes(s, true);
    agaa_PixelSamples samples = agaa_pixelOfLanes(s, group.covered);
    if (hasFragment) {
        agaa_setAggregate(record, group.aggregate);
        if (agaa_laneSample() == 0u) {
            agaa_count(AGAA_COUNT_JOINED_CLASSES, uint(bitCount(group.joining)));
            AGAA_GROUP_COUNT(entry & 0xFFu) = group.count;
            AGAA_GROUP_SEEDS(entry & 0xFFu) = group.seeds;
            AGAA_GROUP_NEAREST(entry & 0xFFu) = floatBitsToUint(samples.nearest);
        }
    }
}

// Assigns the fragments of this lane's pixel that were not clustered to the aggregates with the nearest seeds.
void agaa_assignOthers(uvec2 pixel, uint head, agaa_Entries entries) {
    const uint lane = gl_LocalInvocationIndex;
    const uint count = AGAA_GROUP_COUNT(lane);
    const uint seeds = AGAA_GROUP_SEEDS(lane);
    agaa_PixelSamples samples = agaa_noSamples();
    samples.nearest = uintBitsToFloat(AGAA_GROUP_NEAREST(lane));
    agaa_Lengths lengths = agaa_lengthsFor(agaa_pixelCharacteristicLength(samples), agaa_frame.aggregateThreshold);
    agaa_setLanes(entries.first, entries.count);
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        if (agaa_aggregateOf(record) == agaa_maxClustered) {
            uint best = 0u;
            if (count > 1u && agaa_coverageCount(agaa_maskOf(record)) != 0u) {
                agaa_LaneSample s = agaa_laneSampleOfFragment(pixel, record);
                if (AGAA_GLOSS_WEIGHT != 0u)
                    s.normal = agaa_weighedNormal(mat3(agaa_frame.view) * s.shadingNormal, s.alpha2);
                agaa_NearestSeed nearest = agaa_noSeed();
                for (uint a = 0u; a < count; ++a) {
                    uint seed = seeds >> 8u * a & 0xFFu;
                    agaa_compareSeed(nearest, a, agaa_distanceToSample(s, seed, lengths), s.keyB,
                                     AGAA_CLASSES ? agaa_publishedContent(seed).keyB : 0u);
                }
                best = agaa_countedSeed(nearest);
            }
            agaa_setAggregate(record, best);
        }
        fragment = agaa_nextOf(record);
    }
}

// Assigns each fragment of the resolved list of this lane's pixel to an aggregate. Returns the number of aggregates.
// shown   Number of fragments that show at a sample; 0 without a pixel.
uint agaa_groupFragments(uvec2 pixel, uint head, uint shown) {
    const uint lane = gl_LocalInvocationIndex;
    uint count = min(shown, 1u);
    uint clustered = 0u;
    if (agaa_groupsFragments(shown))
        clustered = agaa_chooseLargest(pixel, head, shown);
    else
        agaa_joinFragments(head);
    agaa_Entries entries = agaa_placeEntries(clustered);
    for (uint round = 0u; round < entries.rounds; ++round) {
        const bool isListed = clustered != 0u && entries.round == round;
        AGAA_ENTRY_PIXEL(lane) = 0u;
        barrier();
        if (isListed)
            agaa_listEntries(head, entries);
        memoryBarrierBuffer(); // lanes of fragments read records that the lanes of pixels wrote, and conversely
        barrier();
        agaa_groupEntries();
        memoryBarrierBuffer();
        barrier();
        if (isListed) {
            count = AGAA_GROUP_COUNT(lane);
            agaa_assignOthers(pixel, head, entries);
        }
        barrier();
    }
    return count;
}

#if AGAA_LIT
// Returns the share of a shadow's light that reaches sample i of a plane. Taps are repeated, because the light of a
// lane's samples has no room in shared memory.
float agaa_lightOfSample(uvec2 pixel, uint map, agaa_DepthPlane plane, uint i, vec2 at, bool isKnown) {
    agaa_countTaps(map, isKnown ? 0u : 1u);
    return agaa_uncountedTap(map, agaa_surfacePosition(pixel, plane, at));
}
#endif
#endif
