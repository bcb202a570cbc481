// Differences of a pixel's samples, and the choice of those that are shaded: the next one is the sample that differs most
// from all that were chosen (farthest-first traversal, Gonzalez 1985), or the next one of the pattern's order. Samples that
// are not chosen belong to the chosen one that they differ least from.
#ifndef AGAA_SAMPLE_CHOICE_GLSL
#define AGAA_SAMPLE_CHOICE_GLSL
#include "math/adaptive.glsl"
#include "passes/adaptive_flags.glsl" // before gbuffer.glsl, which includes some files under conditions
#include "passes/gbuffer.glsl"
#include "passes/sample_depth.glsl"
#include "passes/stored_choice.glsl"

// Of the pixel at hand, by sample: depth, code of the normal, then colours in bytes.
uvec4 agaa_sampleFeatures[AGAA_SAMPLES];
float agaa_distances[AGAA_SAMPLES]; // to the nearest chosen sample
uint agaa_owners[AGAA_SAMPLES];     // that sample

struct agaa_Features {
    vec3 position, normal; // in shading space
    float width;           // how far its plane reaches
    vec4 diffuse, specular; // and alpha; and how bright the sample glows
};

// Sample j of the pattern's order, which begins in the middle; a byte each.
uint agaa_sampleInOrder(uint j) {
    const uint words[8] = uint[8](AGAA_ORDER0, AGAA_ORDER1, AGAA_ORDER2, AGAA_ORDER3, AGAA_ORDER4, AGAA_ORDER5, AGAA_ORDER6,
                                  AGAA_ORDER7);
    return words[j >> 2u] >> (8u * (j & 3u)) & 0xFFu;
}

agaa_Features agaa_unpackFeatures(uvec2 pixel, uint i, uvec4 words) {
    float depth = uintBitsToFloat(words.x);
    vec3 position = agaa_sampleViewPosition(pixel, i, depth);
    agaa_Features f;
    f.position = agaa_toShadingSpace(position);
    f.normal = agaa_decodeOct(unpackUnorm2x16(words.y), agaa_fieldBits(AGAA_SOURCE_NORMAL_X));
    f.width = agaa_frame.surface.y * agaa_pixelWidth(position.z) +
              2.0 * agaa_depthQuantum(position.z, depth, agaa_frame.projection1.x, agaa_frame.projection1.y, agaa_isOrthographic(),
                                      agaa_storedQuantum(depth));
    f.diffuse = unpackUnorm4x8(words.z);
    f.specular = unpackUnorm4x8(words.w);
    return f;
}

// Of the sample fetched last.
uvec4 agaa_packFeatures(float depth) {
    agaa_Surface s = agaa_sampleSurface();
    return uvec4(floatBitsToUint(depth), packUnorm2x16(agaa_normalCode()), packUnorm4x8(vec4(s.diffuse, sqrt(s.alpha2))),
                 packUnorm4x8(vec4(s.specular, agaa_displayLuma(s.emissive))));
}

// How many thresholds apart two samples are: normals, whose differences count the more the glossier the surface; the plane;
// the material.
float agaa_differenceOf(agaa_Features a, agaa_Features b) {
    float gloss = clamp(uintBitsToFloat(AGAA_GLOSS_WEIGHT) / max(min(a.diffuse.w, b.diffuse.w), 0.01), 1.0, 20.0);
    vec4 material = max(abs(a.diffuse - b.diffuse), abs(a.specular - b.specular));
    return max(max(agaa_normalStep(a.normal, b.normal, agaa_frame.surface.x) * gloss,
                   agaa_planeStep(b.position - a.position, a.normal, b.normal, max(a.width, b.width))),
               max(max(material.x, material.y), max(material.z, material.w)) / max(agaa_frame.surface.z, 1e-3));
}

// The first of these samples in the pattern's order.
uint agaa_firstInOrder(uint covered) {
    uint j = 0u;
    while ((covered >> agaa_sampleInOrder(j) & 1u) == 0u)
        ++j;
    return agaa_sampleInOrder(j);
}

#ifdef AGAA_HOST_FETCH
// Loads the pixel's samples, with one material for all of a primitive. Returns those that show geometry.
uint agaa_loadFetched(uvec2 pixel) {
    uint covered = 0u;
    uint i = 0u;
    do
        covered |= agaa_isCovered(pixel, i) ? 1u << i : 0u;
    while (++i < agaa_sampleCount());
    for (uint left = covered; left != 0u;) {
        uint own = agaa_samplesOfPrimitive(pixel, uint(findLSB(left)), left);
        left &= ~own;
        AgaaMaterial m = agaa_fetchMaterial(agaa_primitive(agaa_idOf(pixel, uint(findLSB(own)))), pixel, own);
        agaa_fetched = m;
        for (; own != 0u; own &= own - 1u) {
            uint j = uint(findLSB(own));
            agaa_fetched.normal = agaa_materialNormal(m, j);
            agaa_sampleFeatures[j] = agaa_packFeatures(agaa_depthOf(pixel, j));
        }
    }
    return covered;
}
#else
// Loads the pixel's samples, and chooses the first in order. Returns those that show geometry.
uint agaa_beginChoice(uvec2 pixel) {
    uint covered = 0u;
    uint first = 0u;
    agaa_Features f;
    uint j = 0u;
    do {
        uint i = agaa_sampleInOrder(j);
        if (agaa_fetchSample(pixel, i)) {
            uvec4 words = agaa_packFeatures(agaa_depthOf(pixel, i));
            agaa_Features own = agaa_unpackFeatures(pixel, i, words);
            agaa_sampleFeatures[i] = words;
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
#endif

// After what loads: compilers warn of reads that they meet before writes.
agaa_Features agaa_featuresOf(uvec2 pixel, uint i) { return agaa_unpackFeatures(pixel, i, agaa_sampleFeatures[i]); }

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

#ifdef AGAA_HOST_FETCH
uint agaa_beginChoice(uvec2 pixel) {
    uint covered = agaa_loadFetched(pixel);
    uint i = 0u;
    do
        agaa_distances[i] = 3.0e38;
    while (++i < agaa_sampleCount());
    if (covered != 0u)
        agaa_chooseSample(pixel, covered, agaa_firstInOrder(covered));
    return covered;
}
#endif

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

// Chooses more until there are `least`, and up to `most` as long as one differs enough from all chosen ones. left: how much the
// one differs that would be next, as a share of what calls for a sample.
uint agaa_chooseMore(uvec2 pixel, uint covered, uint chosen, uint least, uint most, out float left) {
    uint count = uint(bitCount(chosen));
    uint end = min(most, uint(bitCount(covered)));
    uint turn = 0u;
    left = 0.0;
    do {
        if (chosen == covered)
            break;
        uint next = agaa_farthestSample(covered, chosen);
        left = clamp(agaa_distances[next] / agaa_differenceLimit(), 0.0, 1.0);
        if (count >= end || (count >= least && !agaa_callsForSample(agaa_distances[next])))
            break;
        next = agaa_isAdaptive(agaa_inOrder) ? agaa_firstInOrder(covered & ~chosen) : next;
        chosen |= 1u << next;
        agaa_chooseSample(pixel, covered, next);
        ++count;
        left = 0.0;
    } while (++turn < agaa_sampleCount());
    return chosen;
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
