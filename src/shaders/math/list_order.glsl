// The order of the fragments of a list (coverage/fragment_layout.glsl). Needs tables/layouts.inc and a function
// agaa_fragmentWord(uint at) that reads the words of fragments.
// Source: hard case 67 (order of draws before merging).
#ifndef AGAA_MATH_LIST_ORDER_GLSL
#define AGAA_MATH_LIST_ORDER_GLSL
#ifndef AGAA_LAYOUTS_INC
#error "list_order.glsl needs layouts.inc."
#endif

// Returns the first word from `first` on that differs between two fragments, or `end`.
uint agaa_firstDifference(uint record, uint other, uint first, uint end) {
    uint word = first;
    while (word < end && agaa_fragmentWord(record + word) == agaa_fragmentWord(other + word))
        ++word;
    return word;
}

// Returns the index of the word that orders two fragments: the depth, then the coverage, neither of which depends on
// the draws, then the id, 0. Fragments without depths are ordered by id.
// coverageEnd   Index of the first word behind the coverage.
uint agaa_orderingWord(uint record, uint other, uint coverageEnd) {
    const bool isByDepth = agaa_fragmentWord(record + AGAA_FRAGMENT_DEPTH_AT) != 0u;
    const uint word = isByDepth ? agaa_firstDifference(record, other, AGAA_FRAGMENT_DEPTH_AT, coverageEnd) : 0u;
    return word < coverageEnd ? word : 0u;
}

#endif
