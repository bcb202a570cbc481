// Chooses samples until there are enough. Needs adaptive/sample_choice.glsl.
#ifndef AGAA_CHOOSE_MORE_GLSL
#define AGAA_CHOOSE_MORE_GLSL
#ifndef AGAA_SAMPLE_CHOICE_GLSL
#error "choose_more.glsl needs sample_choice.glsl."
#endif
#include "adaptive/first_samples.glsl"

// Returns whether pixels may have further samples. If they have enough, `wanted` is set.
// count   Number of chosen samples.
// most    Difference of the sample that would be next.
bool agaa_wantsMore(uint count, float most, float byShading, inout uint wanted, inout float left) {
    if (wanted == 0u && !agaa_callsForSample(most)) {
        left = agaa_shareOfLimit(most);
        wanted = agaa_countBoth(byShading, count, left);
    }
    return wanted == 0u || count < wanted;
}

// Returns the mask of chosen samples.
// wanted      Number of samples; 0: the samples that differ enough from all chosen ones, and those that shading
//             demands.
// byShading   agaa_countByShading().
// left        Receives the difference of the sample that would be next, as a share of the limit.
#if AGAA_SAMPLE_LANES
uint agaa_chooseMore(inout agaa_LaneChoice c, uvec2 pixel, uint wanted, float byShading, out float left) {
    const uint covered = c.sample_.covered;
    uint chosen = covered != 0u ? 1u << c.sample_.first : 0u;
    left = 0.0;
    bool isChoosing = true;
    for (uint iteration = 0u; iteration < AGAA_SAMPLES; ++iteration) {
        isChoosing = isChoosing && chosen != covered;
        if (!agaa_anyLane(isChoosing))
            break;
        float most;
        uint next = agaa_farthestOfLanes(c, chosen, most);
        isChoosing = isChoosing && agaa_wantsMore(uint(bitCount(chosen)), most, byShading, wanted, left);
        if (agaa_isAdaptive(AGAA_ADAPTIVE_IN_ORDER) && isChoosing)
            next = agaa_firstInOrder(covered & ~chosen);
        chosen |= isChoosing ? 1u << next : 0u;
        agaa_chooseLane(c, pixel, isChoosing, next);
    }
    return chosen;
}
#else
uint agaa_chooseMore(uvec2 pixel, uint covered, uint chosen, uint wanted, float byShading, out float left) {
    uint iteration = 0u;
    left = 0.0;
    do {
        if (chosen == covered)
            break;
        uint next = agaa_farthestSample(covered, chosen);
        if (!agaa_wantsMore(uint(bitCount(chosen)), agaa_distances[next], byShading, wanted, left))
            break;
        next = agaa_isAdaptive(AGAA_ADAPTIVE_IN_ORDER) ? agaa_firstInOrder(covered & ~chosen) : next;
        chosen |= 1u << next;
        agaa_chooseSample(pixel, covered, next);
    } while (++iteration < agaa_sampleCount());
    return chosen;
}
#endif
#endif
