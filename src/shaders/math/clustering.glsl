// Aggregate definition: clusters the samples of a pixel that are shaded together.
// Sources: AGAA (Crassin et al., TVCG 2016) section 3.3, Equation 1 and Algorithm 1, with these corrections: seeds by
// maximin distance (the printed rule (e) picks existing seeds), a new aggregate only farther than t from every earlier
// seed, ties broken by content, averages in integers; hard cases 10, 18, 20 to 24, 29 and 30.
//
// Needs AGAA_MAX_SAMPLES; at most 32 samples are clustered. Needs AGAA_CLASSES, whether samples have classes
// (AGAA_FILTER_CLASS), and AGAA_PLANES, whether planes are clustered in place of samples. The includer sets samples by
// agaa_setSample(). The arrays are globals in GLSL and members of a struct in C++. Results do not depend on the order
// of the samples, except the indices of samples with equal content. Loops over samples, of which there is at least one,
// test at their end, because software rasterisers run the code after a test once more.
#ifndef AGAA_MATH_CLUSTERING_GLSL
#define AGAA_MATH_CLUSTERING_GLSL
#ifndef AGAA_MAX_SAMPLES
#error "clustering.glsl needs AGAA_MAX_SAMPLES."
#endif
#if !defined(AGAA_CLASSES) || !defined(AGAA_PLANES)
#error "clustering.glsl needs AGAA_CLASSES and AGAA_PLANES."
#endif
#include "real.glsl"

rvec3 agaa_samplePosition[AGAA_MAX_SAMPLES]; // view space, relative to any origin
rvec3 agaa_sampleNormal[AGAA_MAX_SAMPLES];   // unit
uint agaa_sampleKeyA[AGAA_MAX_SAMPLES];      // depth key
uint agaa_sampleKeyB[AGAA_MAX_SAMPLES];      // normal code and sub-pixel position key; with AGAA_CLASSES, its class and
                                             // the number of samples it stands for are in place of the code
real agaa_sampleStep[AGAA_MAX_SAMPLES];      // length of one step of the depth buffer at the sample
uint agaa_sampleAggregate[AGAA_MAX_SAMPLES]; // result; 0 for samples without geometry
uint agaa_sampleNearest[AGAA_MAX_SAMPLES];   // quantised distance to the nearest seed so far
uint agaa_seedSample[8];                     // sample that founded each aggregate
uint agaa_joiningSamples = 0u;               // result: samples whose class has no aggregate of its own

// Sets a sample with geometry.
void agaa_setSample(uint i, rvec3 position, rvec3 unitNormal, real depthStep, uint keyA, uint keyB) {
    agaa_samplePosition[i] = position;
    agaa_sampleNormal[i] = unitNormal;
    agaa_sampleKeyA[i] = keyA;
    agaa_sampleKeyB[i] = keyB;
    agaa_sampleStep[i] = depthStep;
}

// Distances are compared as multiples of 1/4096, which is below 4e-4, the noise of 8-bit codes of normals.
real agaa_distanceScale() {
    return real(4096.0);
}

// The position term stops growing at 1000 k, so that its square times the scale fits 32 bits.
real agaa_maxPositionTerm() {
    return real(1e6);
}

// Returns 1/k^2 with k clamped to [1e-15, 1e15]. A k of 0, below 0 or NaN counts as 1e-15, an infinite one as 1e15. The
// API rejects such values; here they must only not cause errors.
real agaa_inverseK2(real k) {
    real kk = real(1e-15);
    if (k > kk) {
        kk = min(k, real(1e15));
    }
    return real(1.0) / (kk * kk);
}

// The k of Equation 1 for a pair of samples. The depth buffer may put two samples of one surface a whole step apart, so
// k increases by perStep times the coarser step of the two. A far sample does not change the distance between near
// ones.
struct agaa_Lengths {
    real k;
    real perStep;
};

// With this perStep, samples one step apart are at most a quarter of the threshold t apart:
// (step / k)^2 <= t / 4.
agaa_Lengths agaa_lengthsFor(real k, real t) {
    agaa_Lengths lengths;
    lengths.k = k;
    lengths.perStep = real(2.0) / sqrt(max(t, real(1e-4)));
    return lengths;
}

real agaa_pairInverseK2(agaa_Lengths lengths, real stepA, real stepB) {
    return agaa_inverseK2(lengths.k + lengths.perStep * max(stepA, stepB));
}

// Returns Equation 1, with (1 - na.nb)/2 written as |na - nb|^2 / 4. Both are equal for unit vectors, but the
// difference is exactly 0 for equal normals and keeps its digits for similar ones.
real agaa_sampleDistance(rvec3 pa, rvec3 pb, rvec3 na, rvec3 nb, real inverseK2) {
    const rvec3 dx = pa - pb;
    const rvec3 dn = na - nb;
    return min(dot(dx, dx) * inverseK2, agaa_maxPositionTerm()) +
           min(real(0.25) * dot(dn, dn), real(1.0));
}

// Quantises a distance. From 4 on, the step is 1/8192 to 1/16384 of the value: 14 significant bits are coarser than the
// rounding differences between devices, so that equal distances stay ties, which content breaks. The function is
// monotonic, so that comparisons of quantised values never contradict those of exact ones.
uint agaa_quantiseDistance(real d) {
    const real top = agaa_maxPositionTerm() + real(1.0);
    const uint q = uint(clamp(d, real(0.0), top) * agaa_distanceScale() + real(0.5));
    const uint drop = uint(max(findMSB(q) - 13, 0));
    return ((q + ((1u << drop) >> 1u)) >> drop) << drop;
}

uint agaa_classOfKey(uint keyB) {
    return keyB >> 24u;
}

// Returns the number of samples that a sample stands for: more than 1 if it is a fragment.
uint agaa_weightOfKey(uint keyB) {
    return (keyB >> 16u) & 0xFFu;
}

// Returns a quantised distance between two samples that is larger for those of different classes than for any of one
// class. Each class then gets a seed before samples of one class are divided.
uint agaa_separated(uint distance, uint keyBOfOne, uint keyBOfOther) {
    uint result = distance;
    if (AGAA_CLASSES) {
        const bool differ = agaa_classOfKey(keyBOfOne) != agaa_classOfKey(keyBOfOther);
        result = min(distance, 0x7FFFFFFFu) | (differ ? 0x80000000u : 0u);
    }
    return result;
}

// Returns the quantised threshold t, which different classes exceed.
uint agaa_quantisedThreshold(real t) {
    const uint threshold = agaa_quantiseDistance(max(t, real(0.0)));
    return AGAA_CLASSES ? min(threshold, 0x7FFFFFFFu) : threshold;
}

// Returns the rank of a class, by which classes get aggregates of their own: first by its number of samples.
uint agaa_rankOfClass(uint samples, uint class_) {
    return samples << 8u | class_;
}

bool agaa_sampleIsCovered(uint covered, uint i) {
    return ((covered >> i) & 1u) != 0u;
}

// Sort key: depth, then normal and position; the index breaks ties.
struct agaa_Content {
    uint keyA;
    uint keyB;
    uint sample_;
};

agaa_Content agaa_contentOf(uint i) {
    agaa_Content content;
    content.keyA = agaa_sampleKeyA[i];
    content.keyB = agaa_sampleKeyB[i];
    content.sample_ = i;
    return content;
}

// Returns whether a precedes b. With equal keys either order is valid, and the index makes the result deterministic.
bool agaa_contentPrecedes(agaa_Content a, agaa_Content b) {
    bool precedes = a.sample_ < b.sample_;
    if (a.keyA != b.keyA) {
        precedes = a.keyA < b.keyA;
    } else if (a.keyB != b.keyB) {
        precedes = a.keyB < b.keyB;
    }
    return precedes;
}

// The sample with the largest value so far; content breaks ties. Its values are copies in registers, because arrays of
// a lane are in memory.
struct agaa_Farthest {
    bool any;
    uint value;
    agaa_Content content;
};

agaa_Farthest agaa_noneYet() {
    agaa_Farthest best;
    best.any = false;
    best.value = 0u;
    best.content.keyA = 0u;
    best.content.keyB = 0u;
    best.content.sample_ = 0u;
    return best;
}

void agaa_compare(INOUT(agaa_Farthest) best, uint i, uint value) {
    const agaa_Content content = agaa_contentOf(i);
    if (!best.any || value > best.value ||
        (value == best.value && agaa_contentPrecedes(content, best.content))) {
        best.any = true;
        best.value = value;
        best.content = content;
    }
}

// Returns whether all covered samples have one class.
bool agaa_areAllOneClass(uint n, uint covered) {
    bool one = true;
    if (AGAA_CLASSES && covered != 0u) {
        const uint first = agaa_classOfKey(agaa_sampleKeyB[findLSB(covered)]);
        for (uint i = 0u; i < n; ++i) {
            if (agaa_sampleIsCovered(covered, i)) {
                one = one && agaa_classOfKey(agaa_sampleKeyB[i]) == first;
            }
        }
    }
    return one;
}

// Returns the samples of all classes but the `limit` of highest rank.
uint agaa_findJoining(uint n, uint covered, uint limit) {
    uint joining = covered;
    for (uint k = 0u; k < limit && joining != 0u; ++k) {
        uint highest = 0u;
        uint ofHighest = 0u;
        uint left = joining;
        do {
            const uint class_ = agaa_classOfKey(agaa_sampleKeyB[findLSB(left)]);
            uint samples = 0u;
            uint weight = 0u;
            for (uint i = 0u; i < n; ++i) {
                if (agaa_sampleIsCovered(left, i) && agaa_classOfKey(agaa_sampleKeyB[i]) == class_) {
                    samples = samples | (1u << i);
                    weight += agaa_weightOfKey(agaa_sampleKeyB[i]);
                }
            }
            const uint rank = agaa_rankOfClass(weight, class_);
            ofHighest = rank > highest ? samples : ofHighest;
            highest = max(rank, highest);
            left = left & ~samples;
        } while (left != 0u);
        joining = joining & ~ofHighest;
    }
    return joining;
}

real agaa_pairDistance(uint a, uint b, agaa_Lengths lengths) {
    return agaa_sampleDistance(agaa_samplePosition[a], agaa_samplePosition[b], agaa_sampleNormal[a],
                               agaa_sampleNormal[b],
                               agaa_pairInverseK2(lengths, agaa_sampleStep[a], agaa_sampleStep[b]));
}

// Creates aggregate `id` with seed sample `seed`. Moves all samples that are nearer to it than to their previous seeds,
// and returns the sample that is then farthest from all seeds, the next candidate. Between two seeds at equal distance,
// the one that precedes in content gets the sample.
uint agaa_addSeed(uint n, uint covered, uint id, uint seed, agaa_Lengths lengths) {
    const rvec3 position = agaa_samplePosition[seed];
    const rvec3 normal = agaa_sampleNormal[seed];
    const real depthStep = agaa_sampleStep[seed];
    const agaa_Content content = agaa_contentOf(seed);
    agaa_seedSample[id] = seed; // before the reads, because compilers warn about reads that precede writes
    uint precedes = 0u; // mask of the seeds that the new seed precedes
    for (uint s = 0u; s < id; ++s) {
        if (agaa_contentPrecedes(content, agaa_contentOf(agaa_seedSample[s]))) {
            precedes = precedes | (1u << s);
        }
    }
    agaa_Farthest best = agaa_noneYet();
    uint i = 0u;
    do {
        if (agaa_sampleIsCovered(covered, i)) {
            const uint d = agaa_separated(
                agaa_quantiseDistance(
                    agaa_sampleDistance(agaa_samplePosition[i], position, agaa_sampleNormal[i], normal,
                                        agaa_pairInverseK2(lengths, agaa_sampleStep[i], depthStep))),
                agaa_sampleKeyB[i], content.keyB);
            uint nearest = agaa_sampleNearest[i];
            if (id == 0u || d < nearest ||
                (d == nearest && ((precedes >> agaa_sampleAggregate[i]) & 1u) != 0u)) {
                nearest = d;
                agaa_sampleNearest[i] = d;
                agaa_sampleAggregate[i] = id;
            }
            if (!agaa_sampleIsCovered(agaa_joiningSamples, i)) {
                agaa_compare(best, i, nearest);
            }
        }
    } while (++i < n);
    return best.any ? best.content.sample_ : seed;
}

// Returns the candidate of rule (e) as printed: the sample with the largest sum of squared distances from all seeds.
// Equation 1 is a squared distance (of position/k and half the normal), so its values are summed.
uint agaa_literalCandidate(uint n, uint covered, uint seeds, agaa_Lengths lengths) {
    agaa_Farthest best = agaa_noneYet();
    for (uint i = 0u; i < n; ++i) {
        if (agaa_sampleIsCovered(covered & ~agaa_joiningSamples, i)) {
            uint sum = 0u;
            for (uint s = 0u; s < seeds; ++s) {
                const uint d =
                    agaa_quantiseDistance(agaa_pairDistance(i, agaa_seedSample[s], lengths));
                sum = min(sum, 0xFFFFFFFFu - d) + d;
            }
            if (AGAA_CLASSES) { // a class that no seed has comes first
                sum = min(sum, 0x7FFFFFFFu) | (agaa_sampleNearest[i] & 0x80000000u);
            }
            agaa_compare(best, i, sum);
        }
    }
    return best.content.sample_;
}

// Sums of floats depend on their order. Sums of integers do not: positions are multiples of 2^-20 of the bounding box,
// from its lower corner, and normals are multiples of 2^-20.
real agaa_seedSteps() {
    return real(1048576.0);
}

// Returns the largest magnitude of a normal's components, where gloss weighs them.
real agaa_longestNormal() {
    return real(8.0);
}

// extent   Of the bounding box in its longest direction.
real agaa_seedExtent(real extent) {
    return clamp(extent, real(1e-30), real(1e30));
}

// offset   From the lower corner of the bounding box.
uvec3 agaa_positionSteps(rvec3 offset, real extent) {
    const real steps = agaa_seedSteps();
    const real scale = steps / agaa_seedExtent(extent);
    return uvec3(uint(clamp(offset.x * scale, real(0.0), steps) + real(0.5)),
                 uint(clamp(offset.y * scale, real(0.0), steps) + real(0.5)),
                 uint(clamp(offset.z * scale, real(0.0), steps) + real(0.5)));
}

uvec3 agaa_normalSteps(rvec3 normal) {
    const real steps = agaa_seedSteps();
    const real longest = agaa_longestNormal();
    return uvec3(uint((clamp(normal.x, -longest, longest) + longest) * steps + real(0.5)),
                 uint((clamp(normal.y, -longest, longest) + longest) * steps + real(0.5)),
                 uint((clamp(normal.z, -longest, longest) + longest) * steps + real(0.5)));
}

// The average of a pixel's samples. The position is relative to the lower corner of the bounding box. The mean normal
// is not normalised. Its distance is then the mean of the distances to all normals up to a constant, and cancelling
// normals need no substitute direction.
struct agaa_SampleMean {
    rvec3 position;
    rvec3 normal;
};

// positions, normals   Sums of agaa_positionSteps() and of agaa_normalSteps() over all samples.
agaa_SampleMean agaa_meanOfSteps(uvec3 positions, uvec3 normals, uint count, real extent) {
    const real longest = agaa_longestNormal();
    const real inverse = real(1.0) / (agaa_seedSteps() * real(max(count, 1u)));
    agaa_SampleMean mean;
    mean.position = rvec3(real(positions.x), real(positions.y), real(positions.z)) *
                    (inverse * agaa_seedExtent(extent));
    mean.normal = rvec3(real(normals.x) * inverse - longest, real(normals.y) * inverse - longest,
                        real(normals.z) * inverse - longest);
    return mean;
}

// lowest   Lower corner of the bounding box.
agaa_SampleMean agaa_meanOfSamples(uint n, uint covered, rvec3 lowest, real extent) {
    uint count = 0u;
    uvec3 positions = uvec3(0u, 0u, 0u);
    uvec3 normals = uvec3(0u, 0u, 0u);
    uint i = 0u;
    do {
        if (agaa_sampleIsCovered(covered, i)) {
            positions += agaa_positionSteps(agaa_samplePosition[i] - lowest, extent);
            normals += agaa_normalSteps(agaa_sampleNormal[i]);
            count += 1u;
        }
    } while (++i < n);
    return agaa_meanOfSteps(positions, normals, count, extent);
}

// Returns seed 0, the sample farthest from the average.
uint agaa_firstSeed(uint n, uint covered, agaa_SampleMean mean, rvec3 lowest, real inverseK2) {
    agaa_Farthest best = agaa_noneYet();
    uint i = 0u;
    do {
        if (agaa_sampleIsCovered(covered & ~agaa_joiningSamples, i)) {
            agaa_compare(best, i,
                         agaa_quantiseDistance(agaa_sampleDistance(agaa_samplePosition[i] - lowest, mean.position,
                                                                   agaa_sampleNormal[i], mean.normal, inverseK2)));
        }
    } while (++i < n);
    return best.content.sample_;
}

// Returns whether the distances of all samples of a pixel may exceed the threshold. They never exceed that of the
// corners of their bounding boxes, with the finest of their steps. The margin covers the rounding of the distances that
// are not computed.
bool agaa_mayExceed(real cornerDistance, uint threshold) {
    return agaa_quantiseDistance(cornerDistance * real(1.00001)) > threshold;
}

// Planes that are clustered in place of the samples on them (AGAA section 4.1, which reads them from the compressed
// depth buffer: a plane for each primitive).
#define AGAA_MAX_PLANES 4u
uint agaa_planeSamples[AGAA_MAX_PLANES];
uint agaa_planeFounder[AGAA_MAX_PLANES]; // its first sample by content

// Returns whether sample i is on the plane of sample p, within the steps of both depths, has its class, and is so near
// that it would found no aggregate of its own. Normals need not have unit length.
bool agaa_isOnPlaneOf(uint p, uint i, agaa_Lengths lengths, uint threshold) {
    const rvec3 normal = agaa_sampleNormal[p];
    const rvec3 between = agaa_samplePosition[i] - agaa_samplePosition[p];
    const bool isOneClass = !AGAA_CLASSES || agaa_classOfKey(agaa_sampleKeyB[p]) == agaa_classOfKey(agaa_sampleKeyB[i]);
    return isOneClass && normal == agaa_sampleNormal[i] &&
           abs(dot(normal, between)) <= (agaa_sampleStep[p] + agaa_sampleStep[i]) * sqrt(dot(normal, normal)) &&
           agaa_quantiseDistance(agaa_pairDistance(p, i, lengths)) <= threshold;
}

// Finds the planes of samples, in the order of content. Returns their number, or 0 if there are more than `limit`.
uint agaa_findPlanes(uint n, uint covered, uint limit, agaa_Lengths lengths, uint threshold) {
    uint planes = 0u;
    uint left = covered;
    do {
        agaa_Farthest first = agaa_noneYet();
        for (uint i = 0u; i < n; ++i) {
            if (agaa_sampleIsCovered(left, i)) {
                agaa_compare(first, i, 0u);
            }
        }
        const uint p = first.content.sample_;
        uint onPlane = 0u;
        for (uint i = 0u; i < n; ++i) {
            if (agaa_sampleIsCovered(left, i) && agaa_isOnPlaneOf(p, i, lengths, threshold)) {
                onPlane = onPlane | (1u << i);
            }
        }
        agaa_planeSamples[planes] = onPlane;
        agaa_planeFounder[planes] = p;
        left = left & ~onPlane;
        planes += 1u;
    } while (left != 0u && planes < min(limit, AGAA_MAX_PLANES));
    return left != 0u ? 0u : planes;
}

struct agaa_ClusteredSample {
    rvec3 position;
    rvec3 normal;
    real depthStep;
    uint keyA;
    uint keyB;
};

agaa_ClusteredSample agaa_clusteredSample(uint i) {
    agaa_ClusteredSample s;
    s.position = agaa_samplePosition[i];
    s.normal = agaa_sampleNormal[i];
    s.depthStep = agaa_sampleStep[i];
    s.keyA = agaa_sampleKeyA[i];
    s.keyB = agaa_sampleKeyB[i];
    return s;
}

// Puts the first sample of each plane at the index of the plane. All are read before one is written. Returns the number
// of planes, or 0 and moves nothing if there are more than `limit`.
uint agaa_gatherPlanes(uint n, uint covered, uint limit, agaa_Lengths lengths, uint threshold) {
    const uint planes = agaa_findPlanes(n, covered, limit, lengths, threshold);
    agaa_ClusteredSample first[AGAA_MAX_PLANES];
    for (uint p = 0u; p < planes; ++p) {
        first[p] = agaa_clusteredSample(agaa_planeFounder[p]);
    }
    for (uint p = 0u; p < planes; ++p) {
        agaa_setSample(p, first[p].position, first[p].normal, first[p].depthStep, first[p].keyA, first[p].keyB);
    }
    return planes;
}

// Gives the samples of planes the aggregates of their planes.
void agaa_scatterPlanes(uint n, uint planes) {
    uint aggregates[AGAA_MAX_PLANES];
    for (uint p = 0u; p < planes; ++p) {
        aggregates[p] = agaa_sampleAggregate[p];
    }
    for (uint i = 0u; i < n; ++i) {
        uint id = 0u;
        for (uint p = 0u; p < planes; ++p) {
            id = agaa_sampleIsCovered(agaa_planeSamples[p], i) ? aggregates[p] : id;
        }
        agaa_sampleAggregate[i] = id;
    }
}

// Partitions the covered samples into aggregates and returns their number. Writes ids in the order of the seeds to
// agaa_sampleAggregate. The cost is O(n c), with literal seeds O(n c^2). Samples of different classes are never in one
// aggregate, except those of agaa_joiningSamples: where classes exceed c, those with the fewest samples, or of
// equally many the lowest numbers, join the nearest aggregates.
// covered        Mask of samples with geometry.
// c              Maximum number of aggregates, [1, 8].
// t              Lowest distance of a new aggregate from the others.
// literalSeeds   Not 0: the third and later seeds follow the paper's rule (e).
uint agaa_defineAggregates(uint n, uint covered, uint c, real k, real t, uint literalSeeds) {
    const uint samples = min(n, uint(AGAA_MAX_SAMPLES));
    // A shift by 32 is undefined.
    const uint present = samples < 32u ? covered & ((1u << samples) - 1u) : covered;
    const uint limit = clamp(c, 1u, 8u);
    rvec3 lowest = rvec3(real(0.0), real(0.0), real(0.0));
    rvec3 highest = lowest;
    rvec3 lowestNormal = lowest;
    rvec3 highestNormal = lowest;
    real finest = real(0.0);
    real coarsest = real(0.0);
    bool any = false;
    uint i = 0u;
    do {
        agaa_sampleAggregate[i] = 0u;
        if (agaa_sampleIsCovered(present, i)) {
            const rvec3 p = agaa_samplePosition[i];
            const rvec3 m = agaa_sampleNormal[i];
            lowest = any ? min(lowest, p) : p;
            highest = any ? max(highest, p) : p;
            lowestNormal = any ? min(lowestNormal, m) : m;
            highestNormal = any ? max(highestNormal, m) : m;
            const real depthStep = agaa_sampleStep[i];
            finest = any ? min(finest, depthStep) : depthStep;
            coarsest = any ? max(coarsest, depthStep) : depthStep;
            any = true;
        }
    } while (++i < samples);
    uint aggregates = any ? 1u : 0u;
    agaa_joiningSamples = 0u;
    const bool isOneClass = agaa_areAllOneClass(samples, present);
    if (!isOneClass && limit == 1u) {
        agaa_joiningSamples = agaa_findJoining(samples, present, limit);
    }
    if (any && limit > 1u) {
        const agaa_Lengths lengths = agaa_lengthsFor(k, t);
        const uint threshold = agaa_quantisedThreshold(t);
        const real bound = agaa_sampleDistance(lowest, highest, lowestNormal, highestNormal,
                                               agaa_pairInverseK2(lengths, finest, finest));
        if (!isOneClass || agaa_mayExceed(bound, threshold)) {
            const rvec3 size = highest - lowest;
            const real extent = max(size.x, max(size.y, size.z));
            const agaa_SampleMean mean = agaa_meanOfSamples(samples, present, lowest, extent);
            const uint planes =
                AGAA_PLANES ? agaa_gatherPlanes(samples, present, limit, lengths, threshold) : 0u;
            const uint count = planes != 0u ? planes : samples;
            const uint members = planes != 0u ? (1u << planes) - 1u : present;
            if (!isOneClass && planes == 0u) { // planes have one class each, and there are no more than aggregates
                agaa_joiningSamples = agaa_findJoining(samples, present, limit);
            }
            // All distances to the average use one length, that of the coarsest step.
            uint seed = agaa_firstSeed(count, members, mean, lowest, agaa_pairInverseK2(lengths, coarsest, coarsest));
            uint candidate = agaa_addSeed(count, members, 0u, seed, lengths);
            bool more = true;
            for (uint id = 1u; id < limit && more; ++id) {
                seed = candidate;
                if (literalSeeds != 0u && id > 1u) {
                    seed = agaa_literalCandidate(count, members, id, lengths);
                }
                more = agaa_sampleNearest[seed] > threshold;
                if (more) {
                    candidate = agaa_addSeed(count, members, id, seed, lengths);
                    aggregates = id + 1u;
                }
            }
            if (planes != 0u) {
                agaa_scatterPlanes(samples, planes);
            }
        }
    }
    return aggregates;
}

#endif
