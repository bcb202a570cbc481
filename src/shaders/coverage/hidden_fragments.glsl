// Removes fragments from a sorted list that fragments before them hide at all samples. They take most of the time where
// a pixel has many layers. The includer defines vec2 agaa_listedRange(uvec2 pixel, uint record), the range of the
// fragment's depths, which increase away from the eye. Needs coverage/fragment_words.glsl and
// math/coverage_pattern.glsl.
#ifndef AGAA_HIDDEN_FRAGMENTS_GLSL
#define AGAA_HIDDEN_FRAGMENTS_GLSL
#if !defined(AGAA_FRAGMENT_WORDS_GLSL) || !defined(AGAA_MATH_COVERAGE_PATTERN_GLSL)
#error "hidden_fragments.glsl needs fragment_words.glsl and coverage_pattern.glsl."
#endif

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
        if (!isWhole || range.x < farthest) {
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
