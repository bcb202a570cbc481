// Removes fragments from a sorted list that other fragments hide at all samples. They take most of the time where a
// pixel has many layers. The includer defines vec2 agaa_listedRange(uvec2 pixel, uint record), the range of the
// fragment's depths, which increase away from the eye. Needs coverage/fragment_words.glsl and
// math/coverage_pattern.glsl.
#ifndef AGAA_HIDDEN_FRAGMENTS_GLSL
#define AGAA_HIDDEN_FRAGMENTS_GLSL
#if !defined(AGAA_FRAGMENT_WORDS_GLSL) || !defined(AGAA_MATH_COVERAGE_PATTERN_GLSL)
#error "hidden_fragments.glsl needs fragment_words.glsl and coverage_pattern.glsl."
#endif
#include "math/ordered_bits.glsl"

// Returns whether a fragment with this least depth is behind the pixel's depth bound. The bound is final, so that the
// result does not depend on the order in which fragments were appended.
bool agaa_isBehindBound(uvec2 pixel, float nearest) {
    return agaa_orderedBits(nearest) > ~agaa_fragments.words[agaa_boundOf(pixel, agaa_frame.size)];
}

// Once the fragments that stay cover all samples, each sample shows a depth of at most the largest of theirs. Of equal
// depths the first of the list shows.
void agaa_unlinkCovered(uvec2 pixel, uint head) {
    uvec4 covered = uvec4(0u);
    float farthest = -3e38; // depth of the fragments that cover
    bool isWhole = false;   // they cover all samples
    uint last = 0u;         // the record of the last fragment that stays
    for (uint fragment = head; fragment != 0u;) {
        uint record = agaa_record(fragment);
        uint next = agaa_nextOf(record);
        vec2 range = agaa_listedRange(pixel, record);
        // No fragment hides the nearest one, whose depths may have been rounded beyond the bound.
        if (last == 0u || ((!isWhole || range.x < farthest) && !agaa_isBehindBound(pixel, range.x))) {
            if (last != 0u)
                agaa_setNext(last, fragment);
            last = record;
            if (!isWhole) {
                covered |= agaa_maskOf(record);
                farthest = max(farthest, range.y);
                isWhole = agaa_coverageCount(covered) == AGAA_SAMPLES;
            }
        }
        fragment = next;
    }
    if (last != 0u)
        agaa_setNext(last, 0u);
}
#endif
