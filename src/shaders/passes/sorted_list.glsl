// Lists of fragments in the order of the host's draws.
#ifndef AGAA_SORTED_LIST_GLSL
#define AGAA_SORTED_LIST_GLSL
#include "passes/fragments.glsl"

// Puts the pixel's list in ascending order of ids and returns its first fragment. Fragments that were drawn in that order
// come last first, and each is then placed at once.
uint agaa_sortList(uvec2 pixel) {
    uint head = 0u;
    uint rest = agaa_fragments.words[agaa_headOf(pixel, agaa_frame.size.xy)];
    while (rest != 0u) {
        uint record = agaa_record(rest);
        uint id = agaa_fragments.words[record];
        uint before = 0u;
        uint after = head;
        bool goesOn = head != 0u && agaa_fragments.words[agaa_record(max(head, 1u))] < id;
        while (goesOn) {
            before = after;
            after = agaa_fragments.words[agaa_record(after) + 1u];
            goesOn = after != 0u && agaa_fragments.words[agaa_record(max(after, 1u))] < id;
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
