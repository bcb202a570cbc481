// The part of ids/primitives.glsl with one lane per pixel, which keeps ids and samples in arrays.
#ifndef AGAA_PIXEL_GROUPING_GLSL
#define AGAA_PIXEL_GROUPING_GLSL
#ifndef AGAA_PRIMITIVES_GLSL
#error "pixel_grouping.glsl needs primitives.glsl."
#endif
#include "aggregate/grouping.glsl"

// Values of the current pixel.
uint agaa_sampleIds[AGAA_MAX_SAMPLES];
uint agaa_samplePrimitive[AGAA_MAX_SAMPLES]; // index in the list
uint agaa_primitiveSamples[AGAA_MAX_SAMPLES];

void agaa_keepId(uint i, uint id) { agaa_sampleIds[i] = id; }
uint agaa_keptId(uint i) { return agaa_sampleIds[i]; }
void agaa_keepIdsAgain(uvec2 pixel, bool isWaiting) {}

void agaa_keepEntry(uint index, uint samples) { agaa_primitiveSamples[index] = samples; }
uint agaa_entryAgain(uvec2 pixel, uint index, uint left) { return agaa_primitiveSamples[index]; }

// Returns the clustering input of a pixel, which may be that of another lane.
agaa_PixelSamples agaa_listedSamples(uvec2 pixel, uint lane) {
    agaa_PixelSamples samples = agaa_noSamples();
    uvec2 entries = agaa_entriesOf(lane);
    uint covered = 0u;
    for (uint at = entries.x; at < entries.y; ++at) {
        covered |= agaa_listSamples[at];
        for (uint rest = agaa_listSamples[at]; rest != 0u; rest &= rest - 1u)
            agaa_samplePrimitive[findLSB(rest)] = at;
    }
    uint i = 0u;
    do {
        if ((covered >> i & 1u) != 0u) {
            uint at = agaa_samplePrimitive[i];
            vec3 normal = agaa_listedPlane(at);
            agaa_addSample(samples, pixel, i, normal, agaa_listedCode(at, normal));
        }
    } while (++i < agaa_sampleCount());
    return agaa_withDistance(samples);
}

bool agaa_shadingNormalsAgree(uvec2 pixel, uint covered) {
    if (AGAA_GLOSS_WEIGHT == 0u)
        return true; // planes are compared only
    uint first = uint(findLSB(covered));
    vec3 normal = agaa_listedNormal(agaa_samplePrimitive[first], first);
    float least = 1.0;
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        least = min(least, dot(normal, agaa_listedNormal(agaa_samplePrimitive[i], i)));
    }
    return least >= agaa_frame.surfaceCosine;
}

void agaa_weighNormals(uvec2 pixel, uint covered) {
    uint i = 0u;
    do {
        if ((covered >> i & 1u) != 0u) {
            uint at = agaa_samplePrimitive[i];
            agaa_weighNormal(i, mat3(agaa_frame.view) * agaa_listedNormal(at, i), agaa_listMaterial[at].alpha2);
        }
    } while (++i < agaa_sampleCount());
}

// Groups the samples of a pixel, which may be that of another lane.
void agaa_groupListed(uint lane) {
    uvec2 pixel = agaa_pixelOf(lane);
    agaa_PixelSamples samples = agaa_listedSamples(pixel, lane);
    uint count = agaa_groupSamples(pixel, samples, agaa_sampleCount());
    agaa_count(AGAA_COUNT_JOINED_CLASSES, uint(bitCount(agaa_joiningSamples)));
    agaa_setAggregates(lane, count);
    uint base = lane * AGAA_AGGREGATES;
    for (uint a = 0u; a < AGAA_AGGREGATES; ++a)
        agaa_masks[base + a] = a == 0u && count == 1u ? samples.covered : 0u;
    if (count > 1u)
        for (uint left = samples.covered; left != 0u; left &= left - 1u) {
            uint i = uint(findLSB(left));
            agaa_masks[base + agaa_sampleAggregate[i]] |= 1u << i;
        }
}

// Groups the samples of all complex pixels. All lanes must call it.
void agaa_groupComplexPixels() {
    const uint lane = gl_LocalInvocationIndex;
    if (lane < agaa_complexCount) {
        agaa_groupListed(AGAA_COMPLEX_LANE(lane));
    }
}
#endif
