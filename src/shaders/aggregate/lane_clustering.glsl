// Groups the samples of a pixel that are shaded together, with one lane per sample (aggregate/grouping.glsl and
// math/clustering.glsl have one lane per pixel). The results are equal bit for bit, because loops over samples find
// only minima, maxima, sums of integers and conditions that all samples satisfy.
//
// All lanes of the workgroup call the functions in uniform control flow. Lanes without a sample pass
// agaa_noLaneSample(). Needs aggregate/pixel_samples.glsl and math/sbaa_surfaces.glsl.
#ifndef AGAA_LANE_CLUSTERING_GLSL
#define AGAA_LANE_CLUSTERING_GLSL
#if !defined(AGAA_PIXEL_SAMPLES_GLSL) || !defined(AGAA_MATH_SBAA_SURFACES_GLSL)
#error "lane_clustering.glsl needs pixel_samples.glsl and sbaa_surfaces.glsl."
#endif
#include "aggregate/lanes.glsl"

// The sample of a lane. Without geometry, only isCovered is read.
struct agaa_LaneSample {
    bool isCovered;
    vec3 position;
    vec3 normal;
    float depthStep;
    uint keyA;
    uint keyB;
    // Used with AGAA_GLOSS_WEIGHT. The unit shading normal is in shading space if surfaces are compared by it,
    // otherwise in view space.
    vec3 shadingNormal;
    float alpha2;
};

agaa_LaneSample agaa_noLaneSample() {
    return agaa_LaneSample(false, vec3(0.0), vec3(0.0), 0.0, 0u, 0u, vec3(0.0), 1.0);
}

// Returns sample i of the pixel, which has geometry. The arguments are those of agaa_addSampleAt().
agaa_LaneSample agaa_laneSampleAt(vec3 position, float depth, float quantum, vec2 offset, vec3 normal, uint code) {
    return agaa_LaneSample(true, position, normal, agaa_depthStepAt(position, depth, quantum), floatBitsToUint(depth),
                           agaa_contentKey(offset, code), normal, 1.0);
}

// These functions let the other lanes of the pixel read values of this lane.
void agaa_publishNormal(vec3 normal) {
    const uint lane = agaa_laneIndex();
    AGAA_LANE_WORD(lane, 3u) = floatBitsToUint(normal.x);
    AGAA_LANE_WORD(lane, 4u) = floatBitsToUint(normal.y);
    AGAA_LANE_WORD(lane, 5u) = floatBitsToUint(normal.z);
}
void agaa_publishPlane(agaa_LaneSample s) {
    const uint lane = agaa_laneIndex();
    AGAA_LANE_WORD(lane, 0u) = floatBitsToUint(s.position.x);
    AGAA_LANE_WORD(lane, 1u) = floatBitsToUint(s.position.y);
    AGAA_LANE_WORD(lane, 2u) = floatBitsToUint(s.position.z);
    agaa_publishNormal(s.normal);
    AGAA_LANE_WORD(lane, 6u) = floatBitsToUint(s.depthStep);
}
void agaa_publishContent(agaa_LaneSample s) {
    const uint lane = agaa_laneIndex();
    AGAA_LANE_WORD(lane, 7u) = s.keyA;
    AGAA_LANE_WORD(lane, 8u) = s.keyB;
}

vec3 agaa_publishedVector(uint lane, uint word) {
    return uintBitsToFloat(
        uvec3(AGAA_LANE_WORD(lane, word), AGAA_LANE_WORD(lane, word + 1u), AGAA_LANE_WORD(lane, word + 2u)));
}
vec3 agaa_publishedPosition(uint lane) { return agaa_publishedVector(lane, 0u); }
vec3 agaa_publishedNormal(uint lane) { return agaa_publishedVector(lane, 3u); }

agaa_Plane agaa_publishedPlane(uint lane) {
    return agaa_Plane(agaa_publishedPosition(lane), agaa_publishedNormal(lane),
                      uintBitsToFloat(AGAA_LANE_WORD(lane, 6u)));
}

agaa_Plane agaa_planeOf(agaa_LaneSample s) { return agaa_Plane(s.position, s.normal, s.depthStep); }

// Returns the content of sample i of this lane's pixel.
agaa_Content agaa_publishedContent(uint i) {
    const uint lane = agaa_firstLane() + i;
    return agaa_Content(AGAA_LANE_WORD(lane, 7u), AGAA_LANE_WORD(lane, 8u), i);
}

// Returns the sample with the largest value among the lanes of the pixel that take part; content breaks ties. If no
// lane takes part, the result is any sample.
// largest   Receives its value.
uint agaa_farthestLane(bool takesPart, uint value, agaa_LaneSample s, out uint largest) {
    largest = agaa_maxOfPixel(takesPart ? value : 0u);
    bool isBest = takesPart && value == largest;
    uint best = agaa_samplesWhere(isBest);
    if (agaa_anyLane((best & (best - 1u)) != 0u)) {
        uint keyA = agaa_minOfPixel(isBest ? s.keyA : 0xFFFFFFFFu);
        isBest = isBest && s.keyA == keyA;
        uint keyB = agaa_minOfPixel(isBest ? s.keyB : 0xFFFFFFFFu);
        best = agaa_samplesWhere(isBest && s.keyB == keyB);
    }
    return uint(max(findLSB(best), 0));
}

// Returns a mask of the earlier seeds that the sample `seed` precedes by content. seeds has 8 bits for each of them.
uint agaa_seedsAfter(uint seed, uint seeds, uint count) {
    agaa_Content content = agaa_publishedContent(seed);
    uint after = 0u;
    for (uint k = 0u; k < count; ++k)
        if (agaa_contentPrecedes(content, agaa_publishedContent(seeds >> 8u * k & 0xFFu)))
            after |= 1u << k;
    return after;
}

float agaa_distanceToSample(agaa_LaneSample s, uint other, agaa_Lengths lengths) {
    agaa_Plane plane = agaa_publishedPlane(agaa_firstLane() + other);
    return agaa_sampleDistance(s.position, plane.position, s.normal, plane.normal,
                               agaa_pairInverseK2(lengths, s.depthStep, plane.depthStep));
}

// Returns the distance to a seed, as agaa_addSeed() compares it.
uint agaa_distanceToSeed(agaa_LaneSample s, uint seed, agaa_Lengths lengths) {
    return agaa_separated(agaa_quantiseDistance(agaa_distanceToSample(s, seed, lengths)), s.keyB,
                          AGAA_CLASSES ? agaa_publishedContent(seed).keyB : 0u);
}

bool agaa_areAllOneClassLanes(agaa_LaneSample s, uint covered) {
    if (!AGAA_CLASSES)
        return true;
    uint first = agaa_classOfKey(agaa_publishedContent(uint(max(findLSB(covered), 0))).keyB);
    return agaa_samplesWhere(s.isCovered && agaa_classOfKey(s.keyB) != first) == 0u;
}

// Returns the samples of all classes of the pixel but the AGAA_AGGREGATES of highest rank, as agaa_findJoining() does.
uint agaa_findJoiningLanes(agaa_LaneSample s, uint covered) {
    const uint class_ = agaa_classOfKey(s.keyB);
    uint weight = 0u;
    for (uint left = covered; left != 0u; left &= left - 1u) {
        uint other = agaa_publishedContent(uint(findLSB(left))).keyB;
        weight += agaa_classOfKey(other) == class_ ? agaa_weightOfKey(other) : 0u;
    }
    const uint rank = agaa_rankOfClass(weight, class_);
    bool isJoining = s.isCovered;
    for (uint k = 0u; k < AGAA_AGGREGATES; ++k) {
        uint highest = agaa_maxOfPixel(isJoining ? rank : 0u);
        isJoining = isJoining && rank != highest;
    }
    return agaa_samplesWhere(isJoining);
}

// Returns the sample that is farthest from the average, as agaa_firstSeed() does.
uint agaa_firstSeedLane(bool takesPart, bool maySeed, uint covered, agaa_LaneSample s, vec3 lowest, float extent,
                        float inverseK2) {
    vec3 position = s.position - lowest;
    uvec3 positions = agaa_sumOfPixel(takesPart ? agaa_positionSteps(position, extent) : uvec3(0u));
    uvec3 normals = agaa_sumOfPixel(takesPart ? agaa_normalSteps(s.normal) : uvec3(0u));
    agaa_SampleMean mean = agaa_meanOfSteps(positions, normals, uint(bitCount(covered)), extent);
    uint largest;
    uint d =
        agaa_quantiseDistance(agaa_sampleDistance(position, mean.position, s.normal, mean.normal, inverseK2));
    return agaa_farthestLane(maySeed, d, s, largest);
}

// Returns the candidate of rule (e) as printed, as agaa_literalCandidate() does.
// nearest   Distance of the sample to its seed.
uint agaa_literalSeedLane(bool takesPart, agaa_LaneSample s, uint nearest, uint seeds, uint count,
                          agaa_Lengths lengths) {
    uint sum = 0u;
    for (uint k = 0u; k < count; ++k) {
        uint d = agaa_quantiseDistance(agaa_distanceToSample(s, seeds >> 8u * k & 0xFFu, lengths));
        sum = min(sum, 0xFFFFFFFFu - d) + d;
    }
    if (AGAA_CLASSES)
        sum = min(sum, 0x7FFFFFFFu) | (nearest & 0x80000000u);
    uint largest;
    return agaa_farthestLane(takesPart, sum, s, largest);
}

// Returns whether the samples of the pixel show one surface. The samples are published; with comparesShading their
// normals are then those of shading.
bool agaa_areOneSurfaceLanes(agaa_LaneSample s, uint covered, float width, bool comparesShading) {
    uint largest;
    uint first = agaa_farthestLane(s.isCovered, 0u, s, largest);
    agaa_Plane plane = agaa_publishedPlane(agaa_firstLane() + first);
    bool isOn = agaa_areOnOnePlane(plane, agaa_planeOf(s), agaa_frame.surfaceCosine, width);
    if (AGAA_GLOSS_WEIGHT != 0u && comparesShading) {
        agaa_syncLanes();
        agaa_publishNormal(s.shadingNormal);
        agaa_syncLanes();
        vec3 normal = agaa_publishedNormal(agaa_firstLane() + uint(max(findLSB(covered), 0)));
        isOn = isOn && dot(normal, s.shadingNormal) >= agaa_frame.surfaceCosine;
    }
    return agaa_samplesWhere(s.isCovered && !isOn) == 0u;
}

// The groups of a pixel.
struct agaa_LaneGroup {
    uint covered;   // the pixel's samples with geometry
    uint count;     // number of aggregates
    uint aggregate; // of this lane's sample
    uint seeds;     // of several aggregates: the samples that founded them, 8 bits each
    uint joining;   // samples whose class has no aggregate of its own
};

agaa_PixelSamples agaa_pixelOfLanes(agaa_LaneSample s, uint covered) {
    agaa_PixelSamples none = agaa_noSamples();
    agaa_PixelSamples samples;
    samples.covered = covered;
    samples.nearest = agaa_minOfPixel(s.isCovered ? dot(s.position, s.position) : none.nearest);
    samples.nearestZ = agaa_minOfPixel(s.isCovered ? abs(s.position.z) : none.nearestZ);
    return agaa_withDistance(samples);
}

// Partitions the samples of pixels with `isSplit`, as agaa_defineAggregates() does. The samples are published.
void agaa_clusterLanes(inout agaa_LaneGroup group, agaa_LaneSample s, agaa_PixelSamples samples, bool isSplit,
                       bool isOneClass) {
    const float infinite = uintBitsToFloat(0x7F800000u);
    vec3 lowest = agaa_minOfPixel(s.isCovered ? s.position : vec3(infinite));
    vec3 highest = agaa_maxOfPixel(s.isCovered ? s.position : vec3(-infinite));
    vec3 lowestNormal = agaa_minOfPixel(s.isCovered ? s.normal : vec3(infinite));
    vec3 highestNormal = agaa_maxOfPixel(s.isCovered ? s.normal : vec3(-infinite));
    float finest = agaa_minOfPixel(s.isCovered ? s.depthStep : infinite);
    float coarsest = agaa_maxOfPixel(s.isCovered ? s.depthStep : -infinite);
    const float t = agaa_frame.aggregateThreshold;
    const agaa_Lengths lengths = agaa_lengthsFor(agaa_pixelCharacteristicLength(samples), t);
    const uint threshold = agaa_quantisedThreshold(t);
    float bound = agaa_sampleDistance(lowest, highest, lowestNormal, highestNormal,
                                      agaa_pairInverseK2(lengths, finest, finest));
    if (AGAA_CLASSES && agaa_anyLane(isSplit && !isOneClass))
        group.joining = agaa_findJoiningLanes(s, group.covered);
    bool more = isSplit && (!isOneClass || agaa_mayExceed(bound, threshold));
    if (!agaa_anyLane(more))
        return;
    bool takesPart = more && s.isCovered;
    const bool maySeed = takesPart && !(AGAA_CLASSES && (group.joining >> agaa_laneSample() & 1u) != 0u);
    vec3 size = highest - lowest;
    uint seed = agaa_firstSeedLane(takesPart, maySeed, group.covered, s, lowest, max(size.x, max(size.y, size.z)),
                                   agaa_pairInverseK2(lengths, coarsest, coarsest));
    uint nearest = agaa_distanceToSeed(s, seed, lengths);
    uint seeds = seed; // 8 bits for each aggregate
    uint farthest;
    uint candidate = agaa_farthestLane(maySeed, nearest, s, farthest);
    for (uint id = 1u; id < AGAA_AGGREGATES; ++id) {
        seed = candidate;
        if (AGAA_SEEDS != 0u && id > 1u) {
            seed = agaa_literalSeedLane(maySeed, s, nearest, seeds, id, lengths);
            farthest = agaa_maxOfPixel(agaa_laneSample() == seed ? nearest : 0u);
        }
        more = more && farthest > threshold;
        if (!agaa_anyLane(more))
            break;
        uint after = agaa_seedsAfter(seed, seeds, id);
        uint d = agaa_distanceToSeed(s, seed, lengths);
        if (takesPart && more && (d < nearest || (d == nearest && (after >> group.aggregate & 1u) != 0u))) {
            nearest = d;
            group.aggregate = id;
        }
        seeds |= seed << 8u * id;
        group.seeds = seeds;
        group.count = more ? id + 1u : group.count;
        if (id + 1u < AGAA_AGGREGATES)
            candidate = agaa_farthestLane(maySeed, nearest, s, farthest);
    }
}

// Groups the samples of the pixel, as agaa_groupSamples() does.
// comparesShading   Shading normals distinguish surfaces, too.
agaa_LaneGroup agaa_groupLanes(agaa_LaneSample s, bool comparesShading) {
    agaa_LaneGroup group;
    group.covered = agaa_samplesWhere(s.isCovered);
    group.count = min(group.covered, 1u);
    group.aggregate = 0u;
    group.seeds = 0u;
    group.joining = 0u;
    if (AGAA_AGGREGATES == 1u)
        return group;
    agaa_syncLanes(); // the lanes have read the samples of the previous pixel
    agaa_publishPlane(s);
    agaa_publishContent(s);
    agaa_syncLanes();
    agaa_PixelSamples samples = agaa_pixelOfLanes(s, group.covered);
    const bool isOneClass = agaa_areAllOneClassLanes(s, group.covered); // all lanes call both functions
    const bool isOneSurface =
        agaa_areOneSurfaceLanes(s, group.covered, agaa_surfaceWidth(samples), comparesShading);
    bool isSplit = group.covered != 0u && !(isOneClass && isOneSurface);
    if (!agaa_anyLane(isSplit))
        return group;
    if (AGAA_GLOSS_WEIGHT != 0u) {
        s.normal =
            agaa_weighedNormal(comparesShading ? mat3(agaa_frame.view) * s.shadingNormal : s.shadingNormal, s.alpha2);
        agaa_syncLanes();
        agaa_publishNormal(s.normal);
        agaa_syncLanes();
    }
    agaa_clusterLanes(group, s, samples, isSplit, isOneClass);
    return group;
}

// Returns the samples of an aggregate of this lane's pixel.
uint agaa_samplesOf(agaa_LaneSample s, agaa_LaneGroup group, uint aggregate) {
    return agaa_samplesWhere(s.isCovered && group.aggregate == aggregate);
}
#endif
