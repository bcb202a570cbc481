// Aggregate definition: which samples of a pixel are shaded together.
// Sources: AGAA (Crassin et al., TVCG 2016) section 3.3, Equation 1 and Algorithm 1, with these
// corrections: seeds by maximin distance (the printed rule (e) picks existing seeds), a new
// aggregate only farther than t from every earlier seed, ties broken by content, averages in
// integers; hard cases 10, 18, 20 to 24, 29 and 30.
//
// The including file defines AGAA_MAX_SAMPLES (32 are clustered at most) and fills the inputs by agaa_setSample. The
// arrays are globals in GLSL and members of a struct in C++. Nothing here depends on the order of
// the samples except the names of samples that are equal in content. Loops over samples, of which there
// are one or more, are tested at their end: software rasterisers run what follows a test once more.
#ifndef AGAA_MATH_CLUSTERING_GLSL
#define AGAA_MATH_CLUSTERING_GLSL
#include "real.glsl"

rvec3 agaa_samplePosition[AGAA_MAX_SAMPLES]; // view space, relative to anything
rvec3 agaa_sampleNormal[AGAA_MAX_SAMPLES];   // unit
uint agaa_sampleKeyA[AGAA_MAX_SAMPLES];      // depth key
uint agaa_sampleKeyB[AGAA_MAX_SAMPLES];      // normal code and sub-pixel position key
real agaa_sampleStep[AGAA_MAX_SAMPLES];      // length of one step of the depth buffer at the sample
uint agaa_sampleAggregate[AGAA_MAX_SAMPLES]; // result; 0 for samples without geometry
uint agaa_sampleNearest[AGAA_MAX_SAMPLES];   // quantised distance to the nearest seed so far
uint agaa_seedSample[8];                     // sample that founded each aggregate

// For each sample with geometry.
void agaa_setSample(uint i, rvec3 position, rvec3 unitNormal, real depthStep, uint keyA, uint keyB) {
    agaa_samplePosition[i] = position;
    agaa_sampleNormal[i] = unitNormal;
    agaa_sampleKeyA[i] = keyA;
    agaa_sampleKeyB[i] = keyB;
    agaa_sampleStep[i] = depthStep;
}

// Distances are compared as multiples of 1/4096: finer than the 4e-4 below which the 8-bit normal
// codes are noise.
real agaa_distanceScale() {
    return real(4096.0);
}

// The position term stops growing at 1000 k, so that its square times the scale fits 32 bits.
real agaa_maxPositionTerm() {
    return real(1e6);
}

// 1/k^2 with k held in [1e-15, 1e15]: k of 0, negative or NaN counts as tiny, infinite as huge
// (normals only). The API refuses such values; here they must only not do harm.
real agaa_inverseK2(real k) {
    real kk = real(1e-15);
    if (k > kk) {
        kk = min(k, real(1e15));
    }
    return real(1.0) / (kk * kk);
}

// k of Equation 1 as it applies to a pair of samples: the depth buffer may put two samples of one surface
// a whole step apart, so k grows by perStep times the coarser step of the two. A far sample does not
// change the distance between near ones.
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

// Equation 1, with (1 - na.nb)/2 written as |na - nb|^2 / 4. For unit vectors both are the same,
// but the difference is exactly 0 for equal normals and keeps its digits for similar ones.
real agaa_sampleDistance(rvec3 pa, rvec3 pb, rvec3 na, rvec3 nb, real inverseK2) {
    const rvec3 dx = pa - pb;
    const rvec3 dn = na - nb;
    return min(dot(dx, dx) * inverseK2, agaa_maxPositionTerm()) +
           min(real(0.25) * dot(dn, dn), real(1.0));
}

// From 4 on the step is 1/8192 to 1/16384 of the value, because 14 significant bits are coarser
// than what the roundings of two devices differ by: equal distances stay ties, which content
// decides. Monotone, so that comparisons of the rounded values never contradict those of the exact
// ones.
uint agaa_quantiseDistance(real d) {
    const real top = agaa_maxPositionTerm() + real(1.0);
    const uint q = uint(clamp(d, real(0.0), top) * agaa_distanceScale() + real(0.5));
    const uint drop = uint(max(findMSB(q) - 13, 0));
    return ((q + ((1u << drop) >> 1u)) >> drop) << drop;
}

bool agaa_sampleIsCovered(uint covered, uint i) {
    return ((covered >> i) & 1u) != 0u;
}

// What is compared before the place in the array is, and that.
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

// Equal content means equal keys; then it does not matter which of the two is taken, and the index
// makes the choice definite.
bool agaa_contentPrecedes(agaa_Content a, agaa_Content b) {
    bool precedes = a.sample_ < b.sample_;
    if (a.keyA != b.keyA) {
        precedes = a.keyA < b.keyA;
    } else if (a.keyB != b.keyB) {
        precedes = a.keyB < b.keyB;
    }
    return precedes;
}

// The sample of the largest value so far, of equals the first by content. What is compared with each
// sample is kept in registers: arrays of a lane's own are memory.
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

real agaa_pairDistance(uint a, uint b, agaa_Lengths lengths) {
    return agaa_sampleDistance(agaa_samplePosition[a], agaa_samplePosition[b], agaa_sampleNormal[a],
                               agaa_sampleNormal[b],
                               agaa_pairInverseK2(lengths, agaa_sampleStep[a], agaa_sampleStep[b]));
}

// Founds aggregate `id` at sample `seed`: moves every sample that is nearer to it than to its seed
// so far and returns the sample that is then farthest from all seeds, the next candidate. A sample
// as near to two seeds goes to the seed of lower content.
uint agaa_addSeed(uint n, uint covered, uint id, uint seed, agaa_Lengths lengths) {
    const rvec3 position = agaa_samplePosition[seed];
    const rvec3 normal = agaa_sampleNormal[seed];
    const real depthStep = agaa_sampleStep[seed];
    const agaa_Content content = agaa_contentOf(seed);
    agaa_seedSample[id] = seed; // first: compilers warn of reads that they meet before writes
    uint precedes = 0u; // bit s: seed s
    for (uint s = 0u; s < id; ++s) {
        if (agaa_contentPrecedes(content, agaa_contentOf(agaa_seedSample[s]))) {
            precedes = precedes | (1u << s);
        }
    }
    agaa_Farthest best = agaa_noneYet();
    uint i = 0u;
    do {
        if (agaa_sampleIsCovered(covered, i)) {
            const uint d = agaa_quantiseDistance(agaa_sampleDistance(
                agaa_samplePosition[i], position, agaa_sampleNormal[i], normal,
                agaa_pairInverseK2(lengths, agaa_sampleStep[i], depthStep)));
            uint nearest = agaa_sampleNearest[i];
            if (id == 0u || d < nearest ||
                (d == nearest && ((precedes >> agaa_sampleAggregate[i]) & 1u) != 0u)) {
                nearest = d;
                agaa_sampleNearest[i] = d;
                agaa_sampleAggregate[i] = id;
            }
            agaa_compare(best, i, nearest);
        }
    } while (++i < n);
    return best.any ? best.content.sample_ : seed;
}

// Rule (e) as printed: the sample with the largest sum of squared distances from all seeds.
// Equation 1 is itself a squared distance (of position/k and half the normal), so its values are
// summed.
uint agaa_literalCandidate(uint n, uint covered, uint seeds, agaa_Lengths lengths) {
    agaa_Farthest best = agaa_noneYet();
    for (uint i = 0u; i < n; ++i) {
        if (agaa_sampleIsCovered(covered, i)) {
            uint sum = 0u;
            for (uint s = 0u; s < seeds; ++s) {
                const uint d =
                    agaa_quantiseDistance(agaa_pairDistance(i, agaa_seedSample[s], lengths));
                sum = min(sum, 0xFFFFFFFFu - d) + d;
            }
            agaa_compare(best, i, sum);
        }
    }
    return best.content.sample_;
}

// Seed 0, the sample farthest from the average. Sums of floats depend on their order; offsets from
// the lower corner of the bounding box, in integers of 2^-20 of its size, do not.
uint agaa_firstSeed(uint n, uint covered, rvec3 lowest, real extent, real inverseK2) {
    const real steps = real(1048576.0);
    const real longest = real(8.0); // of a normal's components, where gloss weighs them
    const real size = clamp(extent, real(1e-30), real(1e30));
    const real scale = steps / size;
    uint count = 0u;
    uvec3 sumP = uvec3(0u, 0u, 0u);
    uvec3 sumN = uvec3(0u, 0u, 0u);
    uint i = 0u;
    do {
        if (agaa_sampleIsCovered(covered, i)) {
            const rvec3 p = agaa_samplePosition[i] - lowest;
            const rvec3 m = agaa_sampleNormal[i];
            sumP.x += uint(clamp(p.x * scale, real(0.0), steps) + real(0.5));
            sumP.y += uint(clamp(p.y * scale, real(0.0), steps) + real(0.5));
            sumP.z += uint(clamp(p.z * scale, real(0.0), steps) + real(0.5));
            sumN.x += uint((clamp(m.x, -longest, longest) + longest) * steps + real(0.5));
            sumN.y += uint((clamp(m.y, -longest, longest) + longest) * steps + real(0.5));
            sumN.z += uint((clamp(m.z, -longest, longest) + longest) * steps + real(0.5));
            count += 1u;
        }
    } while (++i < n);
    const real inverse = real(1.0) / (steps * real(max(count, 1u)));
    const rvec3 meanP = rvec3(real(sumP.x), real(sumP.y), real(sumP.z)) * (inverse * size);
    // The mean normal is left unnormalised: its distance is then the mean of the distances to all
    // normals up to a constant, and there is no direction to invent where normals cancel.
    const rvec3 meanN =
        rvec3(real(sumN.x) * inverse - longest, real(sumN.y) * inverse - longest,
              real(sumN.z) * inverse - longest);
    agaa_Farthest best = agaa_noneYet();
    i = 0u;
    do {
        if (agaa_sampleIsCovered(covered, i)) {
            agaa_compare(best, i,
                         agaa_quantiseDistance(agaa_sampleDistance(agaa_samplePosition[i] - lowest, meanP,
                                                                   agaa_sampleNormal[i], meanN, inverseK2)));
        }
    } while (++i < n);
    return best.content.sample_;
}

// Partitions the covered samples into at most c (1 to 8) aggregates, whose number it returns; ids
// go to agaa_sampleAggregate in the order of the seeds. `covered` has a bit for each sample with
// geometry; t is the smallest distance of a new aggregate from the others; literalSeeds != 0 takes
// the paper's rule (e) for the third and later seeds. O(n c), O(n c^2) for literal seeds.
uint agaa_defineAggregates(uint n, uint covered, uint c, real k, real t, uint literalSeeds) {
    const uint samples = min(n, uint(AGAA_MAX_SAMPLES));
    // A shift by 32 is undefined, hence the case distinction.
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
    if (any && limit > 1u) {
        const agaa_Lengths lengths = agaa_lengthsFor(k, t);
        const uint threshold = agaa_quantiseDistance(max(t, real(0.0)));
        // The short way: two samples are never farther apart than the corners of their bounding
        // boxes, by the finest of their steps. The margin covers the rounding of the distances that are
        // not computed.
        const real bound = agaa_sampleDistance(lowest, highest, lowestNormal, highestNormal,
                                               agaa_pairInverseK2(lengths, finest, finest));
        if (agaa_quantiseDistance(bound * real(1.00001)) > threshold) {
            const rvec3 size = highest - lowest;
            const real extent = max(size.x, max(size.y, size.z));
            // Distances to one average are compared by one length, that of the coarsest step.
            uint seed = agaa_firstSeed(samples, present, lowest, extent,
                                       agaa_pairInverseK2(lengths, coarsest, coarsest));
            uint candidate = agaa_addSeed(samples, present, 0u, seed, lengths);
            bool more = true;
            for (uint id = 1u; id < limit && more; ++id) {
                seed = candidate;
                if (literalSeeds != 0u && id > 1u) {
                    seed = agaa_literalCandidate(samples, present, id, lengths);
                }
                more = agaa_sampleNearest[seed] > threshold;
                if (more) {
                    candidate = agaa_addSeed(samples, present, id, seed, lengths);
                    aggregates = id + 1u;
                }
            }
        }
    }
    return aggregates;
}

#endif
