// Chooses samples until there are enough. After sample_choice.glsl.
#ifndef AGAA_CHOOSE_MORE_GLSL
#define AGAA_CHOOSE_MORE_GLSL
#include "adaptive/first_samples.glsl"

// wanted: the number of samples; 0: as many as differ enough from all others that were chosen, and what the shading calls for
// (byShading: agaa_countByShading()). left: the difference of the sample that would be next, as a share of the limit.
uint agaa_chooseMore(uvec2 pixel, uint covered, uint chosen, uint wanted, float byShading, out float left) {
    uint turn = 0u;
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
    } while (++turn < agaa_sampleCount());
    return chosen;
}
#endif
