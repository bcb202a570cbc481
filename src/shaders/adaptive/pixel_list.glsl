// Appends pixels to a list, for groups of later passes that have a pixel in each lane.
#ifndef AGAA_PIXEL_LIST_GLSL
#define AGAA_PIXEL_LIST_GLSL
#include "adaptive/listed_pixels.glsl"

shared uint agaa_groupListed, agaa_groupListedAt;

// Called by all lanes of a group. list: its sums in agaa_choices. Returns the place of this lane's pixel, if it is listed.
uint agaa_listPixel(uvec2 pixel, bool isListed, uint list) {
    const bool isFirst = gl_LocalInvocationIndex == 0u;
    if (isFirst)
        agaa_groupListed = 0u;
    barrier();
    uint place = isListed ? atomicAdd(agaa_groupListed, 1u) : 0u;
    barrier();
    if (isFirst && agaa_groupListed != 0u) {
        agaa_groupListedAt = atomicAdd(agaa_choices.words[list], agaa_groupListed);
        uint groups = (agaa_groupListedAt + agaa_groupListed + 63u) / 64u;
        atomicMax(agaa_choices.words[list + 1u], min(groups, agaa_groupsPerRow));
        atomicMax(agaa_choices.words[list + 2u], (groups + agaa_groupsPerRow - 1u) / agaa_groupsPerRow);
        atomicMax(agaa_choices.words[list + 3u], 1u);
    }
    barrier();
    place += agaa_groupListedAt;
    if (isListed)
        agaa_choices.words[agaa_listAt(place)] = agaa_pixelIndex(pixel);
    return place;
}
#endif
