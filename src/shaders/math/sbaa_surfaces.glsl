// Selects the surfaces that a pixel shows, and the sample by which each is shaded.
// Source: SBAA (Salvi and Vidimce, I3D 2012), merge mode: samples on one plane within tolerances are one
// surface, and the surfaces that cover most are kept. SBAA drops the samples of other surfaces; here they join
// the nearest kept surface, which leaves less error. Primitive ids are not needed, because samples of one
// primitive share its plane.
//
// The input is the samples of clustering.glsl, which the includer sets by agaa_setSample().
#ifndef AGAA_MATH_SBAA_SURFACES_GLSL
#define AGAA_MATH_SBAA_SURFACES_GLSL
#include "clustering.glsl"

uint agaa_surfaceSamples[8]; // result: mask of samples, in descending order of their number before others joined
uint agaa_surfaceShaded[8];  // result: the sample whose attributes represent it

// Clears the results. It precedes all readers, because compilers warn about reads that precede writes.
void agaa_clearSurfaces(uint limit) {
    for (uint s = 0u; s < limit; ++s) {
        agaa_surfaceSamples[s] = 0u;
        agaa_surfaceShaded[s] = 0u;
    }
}

// The plane of one sample. It is a copy in registers.
struct agaa_Plane {
    rvec3 position;
    rvec3 normal;
    real depthStep;
};

agaa_Plane agaa_planeOf(uint i) {
    agaa_Plane plane;
    plane.position = agaa_samplePosition[i];
    plane.normal = agaa_sampleNormal[i];
    plane.depthStep = agaa_sampleStep[i];
    return plane;
}

// Returns whether two samples are on each other's planes. The depths of both may differ by a step.
bool agaa_areOnOnePlane(agaa_Plane a, agaa_Plane b, real cosine, real width) {
    const rvec3 between = b.position - a.position;
    const real farthest = width + a.depthStep + b.depthStep;
    return dot(a.normal, b.normal) >= cosine && abs(dot(a.normal, between)) <= farthest &&
           abs(dot(b.normal, between)) <= farthest;
}

bool agaa_isOnSurface(agaa_Plane plane, uint i, real cosine, real width) {
    return agaa_areOnOnePlane(plane, agaa_planeOf(i), cosine, width);
}

// Returns whether all samples show one surface, that of the first sample by content.
bool agaa_areAllOneSurface(uint n, uint covered, real cosine, real width) {
    agaa_Farthest first = agaa_noneYet();
    uint i = 0u;
    do {
        if (agaa_sampleIsCovered(covered, i)) {
            agaa_compare(first, i, 0u);
        }
    } while (++i < n);
    const agaa_Plane plane = agaa_planeOf(first.content.sample_);
    bool one = true;
    i = 0u;
    do {
        if (agaa_sampleIsCovered(covered, i)) {
            one = one && agaa_isOnSurface(plane, i, cosine, width);
        }
    } while (++i < n);
    return one;
}

// Returns the sample of the mask that is nearest to the mean of their positions. The first one wins ties.
uint agaa_centralSample(uint n, uint mask) {
    rvec3 sum = rvec3(real(0.0), real(0.0), real(0.0));
    rvec3 origin = sum;
    uint count = 0u;
    for (uint i = 0u; i < n; ++i) {
        if (agaa_sampleIsCovered(mask, i)) {
            origin = count == 0u ? agaa_samplePosition[i] : origin;
            sum += agaa_samplePosition[i] - origin; // small numbers: hard case 14
            count += 1u;
        }
    }
    const rvec3 mean = origin + sum / real(max(count, 1u));
    uint best = 0u;
    real bestDistance = real(3.0e38);
    for (uint i = 0u; i < n; ++i) {
        if (agaa_sampleIsCovered(mask, i)) {
            const rvec3 away = agaa_samplePosition[i] - mean;
            const real d = dot(away, away);
            if (d < bestDistance) {
                best = i;
                bestDistance = d;
            }
        }
    }
    return best;
}

// Inserts a surface into the kept ones, in descending order of samples and after equal ones. A full list drops its last
// surface. Returns the number of kept surfaces.
uint agaa_keepSurface(uint kept, uint limit, uint mask) {
    const uint count = uint(bitCount(mask));
    uint index = kept;
    for (uint s = limit; s > 0u; --s) {
        if (s <= kept && uint(bitCount(agaa_surfaceSamples[s - 1u])) < count) {
            index = s - 1u;
        }
    }
    for (uint s = limit; s > 1u; --s) {
        if (s - 1u > index && s - 1u <= kept) {
            agaa_surfaceSamples[s - 1u] = agaa_surfaceSamples[s - 2u];
        }
    }
    if (index < limit) {
        agaa_surfaceSamples[index] = mask;
    }
    return min(kept + 1u, limit);
}

// Selects surfaces and returns their number.
// limit     Maximum number of surfaces, [1, 8].
// width     Tolerance to a plane, without the steps of depth.
// lengths   Those of Equation 1 of AGAA, by which the nearest surface is found.
uint agaa_selectSurfaces(uint n, uint covered, uint limit, real cosine, real width,
                         agaa_Lengths lengths) {
    uint kept = 0u;
    uint left = covered;
    agaa_clearSurfaces(limit);
    for (uint found = 0u; found < n && left != 0u; ++found) {
        const uint seed = uint(findMSB(left & (~left + 1u)));
        const agaa_Plane plane = agaa_planeOf(seed);
        uint mask = 0u;
        uint i = 0u;
        do {
            if (agaa_sampleIsCovered(left, i) &&
                (i == seed || agaa_isOnSurface(plane, i, cosine, width))) {
                mask = mask | (1u << i);
            }
        } while (++i < n);
        left = left & ~mask;
        kept = agaa_keepSurface(kept, limit, mask);
    }
    uint taken = 0u;
    for (uint s = 0u; s < kept; ++s) {
        agaa_surfaceShaded[s] = agaa_centralSample(n, agaa_surfaceSamples[s]);
        taken = taken | agaa_surfaceSamples[s];
    }
    for (uint i = 0u; i < n; ++i) {
        if (agaa_sampleIsCovered(covered & ~taken, i)) {
            uint best = 0u;
            real bestDistance = real(3.0e38);
            for (uint s = 0u; s < kept; ++s) {
                const real d = agaa_pairDistance(i, agaa_surfaceShaded[s], lengths);
                if (d < bestDistance) {
                    best = s;
                    bestDistance = d;
                }
            }
            agaa_surfaceSamples[best] = agaa_surfaceSamples[best] | (1u << i);
        }
    }
    return kept;
}

#endif
