// The choice of samples that are shaded: the next one is the sample that differs most from all that were chosen (farthest-first
// traversal, Gonzalez 1985), or the next one of the pattern's order. Samples that are not chosen belong to the chosen one that
// they differ least from.
#ifndef AGAA_SAMPLE_CHOICE_GLSL
#define AGAA_SAMPLE_CHOICE_GLSL
#include "adaptive/sample_features.glsl"

// Of the pixel at hand, by sample.
float agaa_distances[AGAA_SAMPLES]; // to the nearest chosen sample
uint agaa_owners[AGAA_SAMPLES];     // that sample

// Loads the pixel's samples, and chooses the first in order. Returns those that show geometry.
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

// Before more are chosen: those that do not differ enough from the first to be shaded.
uint agaa_alikeSamples(uint covered) {
    uint alike = 0u;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        alike |= agaa_callsForSample(agaa_distances[i]) ? 0u : 1u << i;
    }
    return alike;
}

void agaa_chooseSample(uvec2 pixel, uint covered, uint chosen) {
    agaa_Features f = agaa_unpackFeatures(pixel, chosen, agaa_sampleFeatures[chosen]);
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        float d = i == chosen ? -1.0 : agaa_differenceOf(f, agaa_unpackFeatures(pixel, i, agaa_sampleFeatures[i]));
        if (d < agaa_distances[i]) {
            agaa_distances[i] = d;
            agaa_owners[i] = chosen;
        }
    }
}

// Of those that are not chosen, in the pattern's order where several differ as much.
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

// The samples that belong to a chosen one.
uint agaa_samplesOf(uint covered, uint chosen) {
    uint samples = 0u;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        samples |= agaa_owners[i] == chosen ? 1u << i : 0u;
    }
    return samples;
}
#endif
