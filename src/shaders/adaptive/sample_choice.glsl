// The choice of samples that are shaded. The next sample is the one that differs most from all chosen ones
// (farthest-first traversal, Gonzalez 1985), or the next one in the pattern's order. Each other sample belongs to the
// chosen one from which it differs least. Needs common/target.glsl.
#ifndef AGAA_SAMPLE_CHOICE_GLSL
#define AGAA_SAMPLE_CHOICE_GLSL
#include "adaptive/sample_features.glsl"

#if AGAA_SAMPLE_LANES
// The sample of this lane. All lanes call the functions.
struct agaa_LaneChoice {
    agaa_LaneFeatures sample_;
    agaa_Features features;
    float distance; // to the nearest chosen sample
    uint owner;     // that sample
};

// Loads a pixel's samples and chooses the first in order.
agaa_LaneChoice agaa_beginLaneChoice(uvec2 pixel) {
    agaa_LaneChoice c;
    c.sample_ = agaa_loadLaneFeatures(pixel);
    c.features = agaa_unpackFeatures(pixel, min(agaa_laneSample(), AGAA_SAMPLES - 1u));
    c.distance = c.sample_.difference;
    c.owner = c.sample_.first;
    return c;
}

// Chooses a sample, in pixels with `chooses`.
void agaa_chooseLane(inout agaa_LaneChoice c, uvec2 pixel, bool chooses, uint chosen) {
    agaa_Features f = agaa_unpackFeatures(pixel, chosen);
    float d = agaa_laneSample() == chosen ? -1.0 : agaa_differenceOf(f, c.features);
    if (chooses && c.sample_.isCovered && d < c.distance) {
        c.distance = d;
        c.owner = chosen;
    }
}

// Returns the sample with the largest difference that is not chosen. Ties are broken by the pattern's order.
// most   Receives the difference.
uint agaa_farthestOfLanes(agaa_LaneChoice c, uint chosen, out float most) {
    const bool isLeft = c.sample_.isCovered && (chosen >> agaa_laneSample() & 1u) == 0u && c.distance > -1.0;
    most = agaa_maxOfPixel(isLeft ? c.distance : -1.0);
    uint farthest = agaa_samplesWhere(isLeft && c.distance == most);
    return farthest != 0u ? agaa_firstInOrder(farthest) : 0u;
}
#else
// Values of the current pixel, by sample.
float agaa_distances[AGAA_SAMPLES]; // to the nearest chosen sample
uint agaa_owners[AGAA_SAMPLES];     // that sample

// Loads the pixel's samples and chooses the first in order. Returns the mask of samples with geometry.
uint agaa_beginChoice(uvec2 pixel) {
    agaa_beginSamples(pixel);
    uint covered = 0u;
    uint first = 0u;
    agaa_Features f;
    uint j = 0u;
    do {
        uint i = agaa_sampleInOrder(j);
        agaa_Features own;
        if (agaa_readFeatures(pixel, i, own)) {
            agaa_keepFeatures(pixel, i);
            if (covered == 0u) {
                f = own;
                first = i;
            }
            covered |= 1u << i;
            agaa_distances[i] = i == first ? -1.0 : agaa_differenceOf(f, own);
            agaa_owners[i] = first;
        }
    } while (++j < agaa_sampleCount());
    return covered;
}

// Returns the samples that do not differ enough from the first to be shaded. Call it before more samples are chosen.
uint agaa_alikeSamples(uint covered) {
    uint alike = 0u;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        alike |= agaa_callsForSample(agaa_distances[i]) ? 0u : 1u << i;
    }
    return alike;
}

void agaa_chooseSample(uvec2 pixel, uint covered, uint chosen) {
    agaa_Features f = agaa_unpackFeatures(pixel, chosen);
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        float d = i == chosen ? -1.0 : agaa_differenceOf(f, agaa_unpackFeatures(pixel, i));
        if (d < agaa_distances[i]) {
            agaa_distances[i] = d;
            agaa_owners[i] = chosen;
        }
    }
}

// Returns the sample with the largest difference that is not chosen. Ties are broken by the pattern's order.
uint agaa_farthestSample(uint covered, uint chosen) {
    uint farthest = 0u;
    float most = -1.0;
    uint j = 0u;
    do {
        uint i = agaa_sampleInOrder(j);
        if (((covered & ~chosen) >> i & 1u) != 0u && agaa_distances[i] > most) {
            most = agaa_distances[i];
            farthest = i;
        }
    } while (++j < agaa_sampleCount());
    return farthest;
}

// Returns the samples that belong to a chosen one.
uint agaa_samplesOf(uint covered, uint chosen) {
    uint samples = 0u;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        samples |= agaa_owners[i] == chosen ? 1u << i : 0u;
    }
    return samples;
}
#endif
#endif
