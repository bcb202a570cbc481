// Shades further samples of listed pixels and writes these pixels (Hollaender et al. 2013, sections 3.1 and 3.2).
#version 450
#extension GL_GOOGLE_include_directive : require
#include "common/subgroup_extensions.glsl"
#if AGAA_SAMPLE_LANES
layout(local_size_x = 64) in; // full subgroups
#else
layout(local_size_x = 8, local_size_y = 8) in;
#endif
#define AGAA_MAX_EVENTS AGAA_SAMPLES
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/target.glsl"
#include "common/counters.glsl"
#include "common/lighting.glsl"
#include "common/output.glsl"
#include "common/event_light.glsl"
#include "adaptive/sample_choice.glsl"
#include "adaptive/choose_more.glsl"
#include "gbuffer/sample_visibility.glsl"
#include "adaptive/listed_pixels.glsl"
#include "common/events.glsl"

// Shared memory holds the owners of a pixel's samples in packed words. The owner of a sample is the chosen sample that
// it belongs to.
const uint agaa_ownerBits = AGAA_SAMPLES > 16u ? 5u : 4u;
const uint agaa_ownersPerWord = 32u / agaa_ownerBits;
const uint agaa_ownerWords = (AGAA_SAMPLES + agaa_ownersPerWord - 1u) / agaa_ownersPerWord;

uint agaa_ownerIn(uint word, uint index) {
    return word >> (agaa_ownerBits * index) & ((1u << agaa_ownerBits) - 1u);
}

#if AGAA_SAMPLE_LANES
uint agaa_ownerOf(uint i) { return AGAA_LANE_WORD(agaa_firstLane() + i, 0u); }
#else
uint agaa_ownerOf(uint i) { return agaa_owners[i]; }
#endif

// Returns the word with the owners of its samples.
uint agaa_ownerWord(uint word, uint covered) {
    uint owners = 0u;
    for (uint k = 0u; k < agaa_ownersPerWord; ++k) {
        uint i = min(word * agaa_ownersPerWord + k, AGAA_SAMPLES - 1u);
        owners |= (covered >> i & 1u) != 0u ? agaa_ownerOf(i) << (agaa_ownerBits * k) : 0u;
    }
    return owners;
}

// Values of each lane's pixel: samples with geometry, their owners, and the samples whose shadows the first one has.
shared uint agaa_laneCovered[64];
shared uint agaa_laneOwners[64u * agaa_ownerWords];
shared uint agaa_laneFirst[64];

uvec2 agaa_pixelOf(uint lane) {
    uint index = agaa_boundedListIndexOf(lane);
    return agaa_pixelAt(lane, agaa_isAdaptive(AGAA_ADAPTIVE_SORTED) ? agaa_sortedAt(index) : agaa_listAt(index),
                        AGAA_FURTHER_AT);
}

// Returns the samples that a shaded sample of a lane's pixel represents.
uint agaa_samplesOfLane(uint lane, uint chosen) {
    uint samples = 0u;
    uint i = 0u;
    do {
        uint word = agaa_laneOwners[lane * agaa_ownerWords + i / agaa_ownersPerWord];
        samples |= agaa_ownerIn(word, i % agaa_ownersPerWord) == chosen ? 1u << i : 0u;
    } while (++i < agaa_sampleCount());
    return samples & agaa_laneCovered[lane];
}

#if AGAA_SAMPLE_LANES
uint agaa_ownedSamples(uint lane, uint covered, uint chosen) { return agaa_samplesOfLane(lane, chosen); }
#else
uint agaa_ownedSamples(uint lane, uint covered, uint chosen) { return agaa_samplesOf(covered, chosen); }
#endif

float agaa_eventWeight(uint samples) {
    return agaa_isAdaptive(AGAA_ADAPTIVE_EQUAL_WEIGHTS) ? 1.0 : float(bitCount(samples));
}

struct agaa_Further {
    agaa_PixelWork work;
    float firstWeight; // of the first sample, which is already shaded
    float weights;     // of all samples
};

// Return the number of samples that earlier passes found, or 0, and otherwise the number that shading demands.
const bool agaa_isCounted = AGAA_COUNTS_FOUND != AGAA_FOUND_WITH_FURTHER;
uint agaa_wantedSamples(uvec2 pixel) { return agaa_isCounted ? agaa_choices.words[agaa_choiceAt(pixel)] : 0u; }
float agaa_shadingDemand(uvec2 pixel) {
    return agaa_isCounted ? 0.0 : uintBitsToFloat(agaa_choices.words[agaa_choiceAt(pixel)]);
}

#if AGAA_SAMPLE_LANES
shared uint agaa_laneChosen[64];

// Chooses samples of the pixels of all lanes. All lanes must call it.
void agaa_choosePixels() {
    for (uint iteration = 0u; iteration < agaa_pixelLanes; ++iteration) {
        const uint lane = agaa_lanePixel(iteration);
        const uvec2 pixel = agaa_pixelOf(lane);
        const bool isInside = all(lessThan(pixel, agaa_frame.size));
        agaa_LaneChoice c = agaa_beginLaneChoice(pixel);
        const uint covered = c.sample_.covered;
        const uint alike = agaa_alikeSamples(c.sample_);
        float left;
        const uint chosen = agaa_chooseMore(c, pixel, isInside ? agaa_wantedSamples(pixel) : 0u,
                                            isInside ? agaa_shadingDemand(pixel) : 0.0, left);
        agaa_syncLanes();
        AGAA_LANE_WORD(agaa_laneIndex(), 0u) = c.owner;
        agaa_syncLanes();
        const uint word = agaa_laneSample();
        if (word < agaa_ownerWords)
            agaa_laneOwners[lane * agaa_ownerWords + word] = agaa_ownerWord(word, covered);
        if (word == 0u) {
            agaa_laneCovered[lane] = covered;
            agaa_laneFirst[lane] = agaa_samplesOfFirst(c.sample_.first, alike, covered);
            agaa_laneChosen[lane] = chosen;
        }
    }
    barrier();
}

uint agaa_chosenSamples(uvec2 pixel) { return agaa_laneChosen[gl_LocalInvocationIndex]; }
#else
void agaa_choosePixels() {}

// Returns the mask of shaded samples, which contains the first.
uint agaa_chosenSamples(uvec2 pixel) {
    const uint lane = gl_LocalInvocationIndex;
    const uint covered = agaa_beginChoice(pixel);
    const uint first = agaa_firstInOrder(covered);
    agaa_laneCovered[lane] = covered;
    agaa_laneFirst[lane] = agaa_samplesOfFirst(first, agaa_alikeSamples(covered), covered);
    float left;
    const uint chosen = agaa_chooseMore(pixel, covered, 1u << first, agaa_wantedSamples(pixel),
                                        agaa_shadingDemand(pixel), left);
    uint word = 0u;
    do
        agaa_laneOwners[lane * agaa_ownerWords + word] = agaa_ownerWord(word, covered);
    while (++word < agaa_ownerWords);
    return chosen;
}
#endif

agaa_Further agaa_furtherOf(uvec2 pixel) {
    const uint lane = gl_LocalInvocationIndex;
    agaa_Further further = agaa_Further(agaa_pixelWork(0u, 0u, 0u), 0.0, 0.0);
    const uint chosen = agaa_chosenSamples(pixel);
    const uint covered = agaa_laneCovered[lane];
    const uint first = agaa_firstInOrder(covered);
    further.work.covered = uint(bitCount(covered));
    for (uint rest = chosen; rest != 0u; rest &= rest - 1u) {
        uint i = uint(findLSB(rest));
        float weight = agaa_eventWeight(agaa_ownedSamples(lane, covered, i));
        further.weights += weight;
        further.firstWeight += i == first ? weight : 0.0;
    }
    further.work.events[0] = agaa_showsEvents() ? chosen : chosen & ~(1u << first);
    agaa_count(AGAA_COUNT_VISIBLE, further.work.covered);
    agaa_count(AGAA_COUNT_ONCE, further.work.covered);
    agaa_countEvents(uint(bitCount(chosen)));
    agaa_count(AGAA_COUNT_PIXELS, 1u);
    return further;
}

// Returns the samples whose shadows sample i is shaded with. Samples similar to the first have the shadows of the
// first, those that belong to another shaded sample included: each sample's shadow counts once.
uint agaa_shadowedSamples(uint lane, uint i, uint samples) {
    if (agaa_isAdaptive(AGAA_ADAPTIVE_EQUAL_WEIGHTS))
        return 1u << i;
    return (agaa_laneFirst[lane] >> i & 1u) != 0u ? agaa_laneFirst[lane] : samples & ~agaa_laneFirst[lane];
}

vec3 agaa_shadeEvent(uint lane, uint i) {
    uvec2 pixel = agaa_pixelOf(lane);
    uint samples = agaa_samplesOfLane(lane, i);
    float weight = agaa_eventWeight(samples);
    agaa_findVisibility(pixel, agaa_shadowedSamples(lane, i, samples));
    agaa_setEvent(pixel, uvec4(samples, 0u, 0u, 0u));
    if (!agaa_isAdaptive(AGAA_ADAPTIVE_EQUAL_WEIGHTS))
        agaa_findSpread(pixel, i, samples);
    agaa_fetchEvent(pixel, i, samples);
    agaa_setEventCustom(agaa_fetchedCustom());
    return agaa_eventLight(0u, 0.0, agaa_sampleSurface(), agaa_samplePosition(pixel, i)) * weight;
}

// Shades all samples of the pixel in one invocation, as in the paper (section 4.2).
vec3 agaa_shadeInLoop(agaa_PixelWork work) {
    vec3 color = vec3(0.0);
    for (uint rest = work.events[0]; rest != 0u; rest &= rest - 1u)
        color += agaa_shadeEvent(gl_LocalInvocationIndex, uint(findLSB(rest)));
    return color;
}

void main() {
    agaa_countBegin();
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool inside = all(lessThan(pixel, agaa_frame.size));
    agaa_Further further = agaa_Further(agaa_pixelWork(0u, 0u, 0u), 0.0, 1.0);
    agaa_choosePixels();
    if (inside)
        further = agaa_furtherOf(pixel);
    vec3 color = agaa_isAdaptive(AGAA_ADAPTIVE_LOOP) ? agaa_shadeInLoop(further.work) : agaa_shadeWork(further.work);
    if (inside) {
        if (!agaa_showsEvents())
            color += agaa_weightedLight(agaa_firstSample(ivec2(pixel)).rgb) * further.firstWeight;
        agaa_writePixel(pixel, further.work, color * float(further.work.covered) / further.weights);
    }
    agaa_countEnd();
}
