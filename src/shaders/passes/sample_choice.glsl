// Differences of a pixel's samples, and the choice of those that are shaded: the next one is the sample that differs most
// from all that were chosen (farthest-first traversal, Gonzalez 1985), or the next one of the pattern's order. Samples that
// are not chosen belong to the chosen one that they differ least from.
#ifndef AGAA_SAMPLE_CHOICE_GLSL
#define AGAA_SAMPLE_CHOICE_GLSL
#include "math/adaptive.glsl"
#include "passes/gbuffer.glsl"
#include "passes/sample_depth.glsl"

// Flags of AgaaAdaptiveSampling.
bool agaa_isAdaptive(uint flag) { return (AGAA_ADAPTIVE_FLAGS & flag) != 0u; }

const uint agaa_byGeometry = 0x01u, agaa_byShading = 0x02u, agaa_printedMetric = 0x04u, agaa_inOrder = 0x08u;
const uint agaa_equalWeights = 0x10u, agaa_shadeInLoops = 0x20u;

// Of the pixel at hand, by sample: view depth, normal, then colours in bytes.
uvec4 agaa_sampleFeatures[AGAA_SAMPLES];
float agaa_distances[AGAA_SAMPLES]; // to the nearest chosen sample
uint agaa_owners[AGAA_SAMPLES];     // that sample
struct agaa_Features {
    vec3 position, normal; // in view space
    float quantum;         // step of its depth
    vec4 diffuse, specular; // and alpha; and how bright the sample glows
};

// Sample j of the pattern's order, which begins in the middle; a byte each.
uint agaa_sampleInOrder(uint j) {
    const uint words[8] = uint[8](AGAA_ORDER0, AGAA_ORDER1, AGAA_ORDER2, AGAA_ORDER3, AGAA_ORDER4, AGAA_ORDER5, AGAA_ORDER6,
                                  AGAA_ORDER7);
    return words[j >> 2u] >> (8u * (j & 3u)) & 0xFFu;
}

uvec4 agaa_featuresOfFetched(float depth) {
    agaa_Surface s = agaa_sampleSurface();
    uint code = packUnorm2x16(agaa_encodeOct(mat3(agaa_frame.view) * s.normal, 16u));
    return uvec4(floatBitsToUint(depth), code, packUnorm4x8(vec4(s.diffuse, sqrt(s.alpha2))),
                 packUnorm4x8(vec4(s.specular, agaa_displayLuma(s.emissive))));
}

agaa_Features agaa_featuresOf(uvec2 pixel, uint i) {
    uvec4 words = agaa_sampleFeatures[i];
    float depth = uintBitsToFloat(words.x);
    agaa_Features f;
    f.position = agaa_sampleViewPosition(pixel, i, depth);
    f.quantum = agaa_depthQuantum(f.position.z, depth, agaa_frame.projection1.x, agaa_frame.projection1.y, agaa_isOrthographic(),
                                  agaa_storedQuantum(depth));
    f.normal = agaa_decodeOct(unpackUnorm2x16(words.y), 16u);
    f.diffuse = unpackUnorm4x8(words.z);
    f.specular = unpackUnorm4x8(words.w);
    return f;
}

// Returns the samples that show geometry.
uint agaa_loadFeatures(uvec2 pixel) {
    uint covered = 0u;
    uint i = 0u;
    do {
        if (agaa_fetchSample(pixel, i)) {
            covered |= 1u << i;
            agaa_sampleFeatures[i] = agaa_featuresOfFetched(agaa_depthOf(pixel, i));
        }
    } while (++i < agaa_sampleCount());
    return covered;
}

// How many thresholds apart two samples are: normals, whose differences count the more the glossier the surface; the plane;
// the material.
float agaa_differenceOf(agaa_Features a, agaa_Features b) {
    float gloss = clamp(uintBitsToFloat(AGAA_GLOSS_WEIGHT) / max(min(a.diffuse.w, b.diffuse.w), 0.01), 1.0, 20.0);
    float width = agaa_frame.surface.y * agaa_pixelWidth(a.position.z) + a.quantum + b.quantum;
    vec4 material = max(abs(a.diffuse - b.diffuse), abs(a.specular - b.specular));
    return max(max(agaa_normalStep(a.normal, b.normal, agaa_frame.surface.x) * gloss,
                   agaa_planeStep(b.position - a.position, a.normal, b.normal, width)),
               max(max(material.x, material.y), max(material.z, material.w)) / max(agaa_frame.surface.z, 1e-3));
}

// The first of these samples in the pattern's order.
uint agaa_firstInOrder(uint covered) {
    uint j = 0u;
    while ((covered >> agaa_sampleInOrder(j) & 1u) == 0u)
        ++j;
    return agaa_sampleInOrder(j);
}

void agaa_chooseSample(uvec2 pixel, uint covered, uint chosen) {
    agaa_Features f = agaa_featuresOf(pixel, chosen);
    for (uint rest = covered; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        float d = i == chosen ? -1.0 : agaa_differenceOf(f, agaa_featuresOf(pixel, i));
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

// Chooses the first sample of one or more, as agaa_loadFeatures() left them.
uint agaa_beginChoice(uvec2 pixel, uint covered) {
    uint i = 0u;
    do
        agaa_distances[i] = 3.0e38;
    while (++i < agaa_sampleCount());
    uint first = agaa_firstInOrder(covered);
    agaa_chooseSample(pixel, covered, first);
    return 1u << first;
}

// Chooses more until there are `least`, and up to `most` as long as one differs from all chosen ones by more than the
// thresholds.
uint agaa_chooseMore(uvec2 pixel, uint covered, uint chosen, uint least, uint most) {
    uint count = uint(bitCount(chosen));
    uint end = min(most, uint(bitCount(covered)));
    uint turn = 0u;
    do {
        if (count < end) {
            uint next = agaa_farthestSample(covered, chosen);
            if (count < least || agaa_distances[next] > 1.0) {
                next = agaa_isAdaptive(agaa_inOrder) ? agaa_firstInOrder(covered & ~chosen) : next;
                chosen |= 1u << next;
                agaa_chooseSample(pixel, covered, next);
                ++count;
            } else {
                end = 0u;
            }
        }
    } while (++turn < agaa_sampleCount() && count < end);
    return chosen;
}

// How far the sample that differs most is from all chosen ones, [0, 1].
float agaa_leftDifference(uint covered, uint chosen) {
    return (covered & ~chosen) != 0u ? clamp(agaa_distances[agaa_farthestSample(covered, chosen)], 0.0, 1.0) : 0.0;
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
