// Lists of fragments in the order of the host's draws.
#ifndef AGAA_LIST_ORDER_GLSL
#define AGAA_LIST_ORDER_GLSL
#include "coverage/fragment_words.glsl"

// id: of the second. Fragments that carry materials may share a number: then their words decide, so that frames repeat.
bool agaa_isBefore(uint record, uint other, uint id) {
    uint own = agaa_fragments.words[record];
#ifdef AGAA_MATERIAL_LISTS
    if (own == id) {
        uint word = 2u;
        while (word + 1u < AGAA_FRAGMENT_WORDS && agaa_fragments.words[record + word] == agaa_fragments.words[other + word])
            ++word;
        return agaa_fragments.words[record + word] < agaa_fragments.words[other + word];
    }
#endif
    return own < id;
}

// Puts the pixel's list in ascending order of ids and returns its first fragment. Fragments that were drawn in that order
// come last first, and each is then placed at once.
uint agaa_sortList(uvec2 pixel) {
    uint head = 0u;
    uint rest = agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size)];
    while (rest != 0u) {
        uint record = agaa_record(rest);
        uint id = agaa_fragments.words[record];
        uint before = 0u;
        uint after = head;
        bool predicateBuffer = head != 0u && agaa_isBefore(agaa_record(max(head, 1u)), record, id);
        while (predicateBuffer) {
            before = after;
            after = agaa_fragments.words[agaa_record(after) + 1u];
            predicateBuffer = after != 0u && agaa_isBefore(agaa_record(max(after, 1u)), record, id);
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
