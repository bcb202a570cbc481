// Aggregate ids of the samples of one pixel as bit planes: bit i of plane b is bit b of sample i's id.
// Source: AGAA (Crassin et al., TVCG 2016) section 3.3, figure 5 and Algorithm 2. Planes take the same
// n ceil(log2 c) bits as ids side by side, give the samples of an aggregate in one operation, and need
// neither the mask c-1 that loses an id for c=3 (hard case 29) nor shifts of 32 (hard case 30).
#ifndef AGAA_MATH_METADATA_GLSL
#define AGAA_MATH_METADATA_GLSL
#include "real.glsl"

// Sets the id of a sample, for up to 4 aggregates.
void agaa_putAggregateId(INOUT(uvec2) planes, uint index, uint id) {
    planes.x = planes.x | ((id & 1u) << index);
    planes.y = planes.y | (((id >> 1u) & 1u) << index);
}

// Returns the samples whose id is `aggregate`. Samples without geometry have id 0.
uint agaa_samplesOfAggregate(uvec2 planes, uint aggregate) {
    const uint low = (aggregate & 1u) != 0u ? planes.x : ~planes.x;
    const uint high = (aggregate & 2u) != 0u ? planes.y : ~planes.y;
    return low & high;
}

// Returns the samples of a fragment that no earlier fragment has claimed. Coplanar duplicates all pass a depth test of
// equality, but each sample counts once (hard case 25).
uint agaa_freshSamples(uint fragment, uint claimed) {
    return fragment & ~claimed;
}

// Returns the planes as stored: in one channel if they fit in 32 bits, otherwise one per channel.
uvec2 agaa_storedPlanes(uvec2 planes, uint n, uint c) {
    if (c <= 2u) {
        return uvec2(planes.x, 0u);
    }
    return n < 32u ? uvec2(planes.x | (planes.y << (n & 31u)), 0u) : planes;
}

uvec2 agaa_loadedPlanes(uvec2 stored, uint n, uint c) {
    if (c <= 2u) {
        return uvec2(stored.x, 0u);
    }
    // Bits of the other plane stay above n; sample masks do not reach there.
    return n < 32u ? uvec2(stored.x, stored.x >> (n & 31u)) : stored;
}

#endif
