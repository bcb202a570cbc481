// Appends pixels to a list, from which later passes process one pixel per lane. Needs common/frame.glsl.
#ifndef AGAA_PIXEL_LIST_GLSL
#define AGAA_PIXEL_LIST_GLSL
#include "adaptive/listed_pixels.glsl"

shared uint agaa_groupListed, agaa_groupListedAt;

// Returns the index of this lane's pixel in the list, if it is listed. All lanes of a group must call it.
// list   Index of the list's first word in agaa_choices.
uint agaa_listPixel(uvec2 pixel, bool isListed, uint list) {
    const bool isFirst = gl_LocalInvocationIndex == 0u;
    if (isFirst)
        agaa_groupListed = 0u;
    barrier();
    uint index = isListed ? atomicAdd(agaa_groupListed, 1u) : 0u;
    barrier();
    if (isFirst && agaa_groupListed != 0u) {
        agaa_groupListedAt = atomicAdd(agaa_choices.words[list], agaa_groupListed);
        uint groups = (agaa_groupListedAt + agaa_groupListed + (AGAA_ITEMS_PER_GROUP - 1u)) / AGAA_ITEMS_PER_GROUP;
        atomicMax(agaa_choices.words[list + 1u], min(groups, AGAA_GROUPS_PER_ROW));
        atomicMax(agaa_choices.words[list + 2u], (groups + AGAA_GROUPS_PER_ROW - 1u) / AGAA_GROUPS_PER_ROW);
        atomicMax(agaa_choices.words[list + 3u], 1u);
    }
    barrier();
    index += agaa_groupListedAt;
    if (isListed)
        agaa_choices.words[agaa_listAt(index)] = agaa_pixelIndex(pixel);
    return index;
}
#endif
