// Sorts fragment lists in the order of the host's draws. Needs what coverage/fragment_words.glsl needs.
#ifndef AGAA_LIST_ORDER_GLSL
#define AGAA_LIST_ORDER_GLSL
#include "coverage/fragment_words.glsl"

// Returns whether the first fragment precedes the second, whose id is given. Fragments of material lists may share a
// number; their words then decide, so that frames are repeatable.
bool agaa_isBefore(uint record, uint other, uint id) {
    uint firstId = agaa_fragments.words[record];
#ifdef AGAA_MATERIAL_LISTS
    if (firstId == id) {
        uint word = AGAA_FRAGMENT_MASK_AT;
        while (word + 1u < AGAA_FRAGMENT_WORDS &&
               agaa_fragments.words[record + word] == agaa_fragments.words[other + word])
            ++word;
        return agaa_fragments.words[record + word] < agaa_fragments.words[other + word];
    }
#endif
    return firstId < id;
}

// Sorts the pixel's list in ascending order of ids and returns its first fragment. Lists are in reverse order of the
// draws, so that the insertion of most fragments takes one step.
uint agaa_sortList(uvec2 pixel) {
    uint head = 0u;
    uint rest = agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size)];
    while (rest != 0u) {
        uint record = agaa_record(rest);
        uint id = agaa_fragments.words[record];
        uint before = 0u;
        uint after = head;
        bool isLater = head != 0u && agaa_isBefore(agaa_record(max(head, 1u)), record, id);
        while (isLater) {
            before = after;
            after = agaa_fragments.words[agaa_record(after) + 1u];
            isLater = after != 0u && agaa_isBefore(agaa_record(max(after, 1u)), record, id);
        }
        uint next = agaa_fragments.words[record + 1u];
        agaa_fragments.words[record + 1u] = after;
        if (before == 0u)
            head = rest;
        else
            agaa_fragments.words[agaa_record(before) + 1u] = rest;
        rest = next;
    }
    return head;
}
#endif
