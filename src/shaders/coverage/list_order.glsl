// Sorts fragment lists by depth, so that the result does not depend on the order of the host's draws (hard case 67).
// Needs what coverage/fragment_words.glsl needs.
#ifndef AGAA_LIST_ORDER_GLSL
#define AGAA_LIST_ORDER_GLSL
#include "coverage/fragment_words.glsl"

uint agaa_fragmentWord(uint at) { return agaa_fragments.words[at]; }
#include "math/list_order.glsl"

// Returns whether the first fragment precedes the second. Fragments of material lists may share an id; their further
// words then decide, so that frames are repeatable.
bool agaa_isBefore(uint record, uint other) {
    uint word = agaa_orderingWord(record, other, AGAA_PAYLOAD_AT);
#ifdef AGAA_MATERIAL_LISTS
    if (word == 0u && agaa_fragmentWord(record) == agaa_fragmentWord(other))
        word = agaa_firstDifference(record, other, AGAA_FRAGMENT_MASK_AT, AGAA_FRAGMENT_WORDS - 1u);
#endif
    uint own = agaa_fragmentWord(record + word), others = agaa_fragmentWord(other + word);
    return AGAA_REVERSE_ORDER != 0u ? own > others : own < others;
}

struct agaa_SortedRuns {
    uint head;  // first fragment
    uint count; // runs
};

// Merges neighbouring runs, which have `width` fragments each.
agaa_SortedRuns agaa_mergeRuns(uint head, uint width) {
    agaa_SortedRuns merged = agaa_SortedRuns(0u, 0u);
    uint last = 0u; // the record before the next one
    uint left = head;
    while (left != 0u) {
        uint right = left;
        uint leftCount = 0u;
        while (leftCount < width && right != 0u) {
            right = agaa_nextOf(agaa_record(right));
            ++leftCount;
        }
        uint rightCount = right != 0u ? width : 0u;
        while (leftCount + rightCount != 0u) {
            bool isRight =
                leftCount == 0u || (rightCount != 0u && agaa_isBefore(agaa_record(right), agaa_record(left)));
            uint taken = isRight ? right : left;
            uint record = agaa_record(taken);
            uint next = agaa_nextOf(record);
            if (last == 0u)
                merged.head = taken;
            else
                agaa_setNext(last, taken);
            last = record;
            if (isRight) {
                right = next;
                rightCount = next != 0u ? rightCount - 1u : 0u;
            } else {
                left = next;
                --leftCount;
            }
        }
        left = right;
        ++merged.count;
    }
    if (last != 0u)
        agaa_setNext(last, 0u);
    return merged;
}

// Sorts the pixel's list from front to back and returns its first fragment. The runs of a merge sort double, because
// software rasterisers of Mesa end all loops of an invocation after 65535 iterations in total.
uint agaa_sortList(uvec2 pixel) {
    agaa_SortedRuns runs = agaa_SortedRuns(agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size)], 2u);
    for (uint width = 1u; runs.count > 1u; width *= 2u)
        runs = agaa_mergeRuns(runs.head, width);
    return runs.head;
}
#endif
