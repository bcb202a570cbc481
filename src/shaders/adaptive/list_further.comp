// Decides the number of samples of each pixel by both metrics (Hollaender et al. 2013, section 3.1), lists the pixels
// with several samples, and writes the others.
#version 450
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/bindings.glsl"
#include "common/constants.glsl"
#include "common/frame.glsl"
#include "common/counters.glsl"
#include "adaptive/first_samples.glsl"
#include "adaptive/pixel_list.glsl"
#include "common/pixel_work.glsl"
#include "common/tile_pixels.glsl"

shared uint agaa_tileMaximum;

// Returns the mean of counts over frames, or this frame's count if that is larger.
// count   Number of samples that both metrics demand in this frame.
uint agaa_remember(uvec2 pixel, uint count) {
    float mean = uintBitsToFloat(agaa_choices.words[agaa_meanAt(pixel)]);
    mean = agaa_meanOfCounts(mean, count, uintBitsToFloat(AGAA_COUNT_MEMORY));
    agaa_choices.words[agaa_meanAt(pixel)] = floatBitsToUint(mean);
    return count == 0u ? 0u : agaa_wholeCount(mean - 0.5, count, AGAA_SAMPLES);
}

// Makes the sample counts of neighbouring pixels similar (section 4.2). All lanes of a tile must call it.
uint agaa_evenCount(uint count, uint covered) {
    if (agaa_isAdaptive(AGAA_ADAPTIVE_TILE_MAXIMUM)) {
        if (gl_LocalInvocationIndex == 0u)
            agaa_tileMaximum = 0u;
        barrier();
        atomicMax(agaa_tileMaximum, count);
        barrier();
        count = count != 0u ? agaa_tileMaximum : 0u;
    }
    return min(agaa_isAdaptive(AGAA_ADAPTIVE_BUCKETS) ? agaa_bucketOfCount(count) : count, covered);
}

void agaa_completePixel(uvec2 pixel, uint covered) {
    agaa_count(AGAA_COUNT_VISIBLE, covered);
    agaa_count(AGAA_COUNT_ONCE, covered);
    agaa_countEvents(covered != 0u ? 1u : 0u);
    agaa_count(AGAA_COUNT_PIXELS, covered != 0u ? 1u : 0u);
    agaa_writePixel(pixel, agaa_pixelWork(covered != 0u ? 1u : 0u, 0u, covered),
                    agaa_weightedLight(agaa_firstSample(ivec2(pixel)).rgb) * float(covered));
}

void main() {
    agaa_countBegin();
    uvec2 pixel = agaa_pixelOf(gl_LocalInvocationIndex);
    bool isInside = all(lessThan(pixel, agaa_frame.size));
    uint covered = 0u, count = 0u;
    float byShading = 0.0;
    if (isInside) {
        uint word = agaa_choices.words[agaa_choiceAt(pixel)];
        covered = agaa_coveredIn(word);
        count = agaa_countIn(word);
        if (covered != 0u) {
            byShading = agaa_countByShading(pixel);
            count = min(agaa_countBoth(byShading, count, agaa_leftIn(word)), covered);
        }
        if (AGAA_COUNT_MEMORY != 0u)
            count = agaa_remember(pixel, count);
    }
    count = agaa_evenCount(count, covered);
    // Debug views need the data that only the pass for further samples has.
    bool isListed = count > 1u || (agaa_showsEvents() && covered != 0u);
    uint index = agaa_listPixel(pixel, isListed, AGAA_FURTHER_AT);
    if (isListed)
        agaa_choices.words[agaa_choiceAt(pixel)] =
            AGAA_COUNTS_FOUND == AGAA_FOUND_WITH_FURTHER ? floatBitsToUint(byShading) : count;
    if (isListed && agaa_isAdaptive(AGAA_ADAPTIVE_SORTED))
        agaa_choices.words[agaa_rankAt(index)] =
            count << AGAA_RANK_BITS | atomicAdd(agaa_choices.words[AGAA_TALLY_AT + count], 1u);
    if (isInside && !isListed)
        agaa_completePixel(pixel, covered);
    agaa_countEnd();
}
