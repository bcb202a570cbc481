// Chooses samples until there are enough. Needs adaptive/sample_choice.glsl.
#ifndef AGAA_CHOOSE_MORE_GLSL
#define AGAA_CHOOSE_MORE_GLSL
#ifndef AGAA_SAMPLE_CHOICE_GLSL
#error "choose_more.glsl needs sample_choice.glsl."
#endif
#include "adaptive/first_samples.glsl"

// Returns the mask of chosen samples.
// wanted      Number of samples; 0: the samples that differ enough from all chosen ones, and those that shading
//             demands.
// byShading   agaa_countByShading().
// left        Receives the difference of the sample that would be next, as a share of the limit.
uint agaa_chooseMore(uvec2 pixel, uint covered, uint chosen, uint wanted, float byShading, out float left) {
    uint iteration = 0u;
    left = 0.0;
    do {
        if (chosen == covered)
            break;
        uint next = agaa_farthestSample(covered, chosen);
        uint count = uint(bitCount(chosen));
        if (wanted == 0u && !agaa_callsForSample(agaa_distances[next])) {
            left = agaa_shareOfLimit(agaa_distances[next]);
            wanted = agaa_countBoth(byShading, count, left);
        }
        if (wanted != 0u && count >= wanted)
            break;
        next = agaa_isAdaptive(AGAA_ADAPTIVE_IN_ORDER) ? agaa_firstInOrder(covered & ~chosen) : next;
        chosen |= 1u << next;
        agaa_chooseSample(pixel, covered, next);
    } while (++iteration < agaa_sampleCount());
    return chosen;
}
#endif
