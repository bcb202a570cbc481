// The part of ids/primitives.glsl with one lane per sample. A lane lists the primitives of a pixel, and keeps the ids
// of its samples in shared memory until samples are grouped.
#ifndef AGAA_LANE_GROUPING_GLSL
#define AGAA_LANE_GROUPING_GLSL
#ifndef AGAA_PRIMITIVES_GLSL
#error "lane_grouping.glsl needs primitives.glsl."
#endif
#include "aggregate/lane_clustering.glsl"

void agaa_keepId(uint i, uint id) { AGAA_LANE_WORD(gl_LocalInvocationIndex, i) = id; }
uint agaa_keptId(uint i) { return AGAA_LANE_WORD(gl_LocalInvocationIndex, i); }

// Loads the ids of a pixel that waits for room in the list again, because other data replaced them.
void agaa_keepIdsAgain(uvec2 pixel, bool isWaiting) {
    if (isWaiting)
        agaa_loadIds(pixel);
}

void agaa_keepEntry(uint index, uint samples) {}
uint agaa_entryAgain(uvec2 pixel, uint index, uint left) {
    uint ofPrimitive;
    return agaa_findEntry(pixel, left, ofPrimitive);
}

// Returns the sample of this lane in a listed pixel.
// lane   The lane that listed the pixel.
agaa_LaneSample agaa_listedLaneSample(uvec2 pixel, uint lane) {
    agaa_LaneSample s = agaa_noLaneSample();
    const uint i = agaa_laneSample();
    const uvec2 entries = agaa_entriesOf(lane);
    uint at = entries.y;
    for (uint k = entries.x; k < entries.y; ++k)
        at = (agaa_listSamples[k] >> i & 1u) != 0u ? k : at;
    if (at < entries.y) {
        vec3 normal = agaa_listedPlane(at);
        float depth = agaa_depthOf(pixel, i);
        s = agaa_laneSampleAt(agaa_sampleViewPosition(pixel, i, depth), depth, agaa_storedQuantum(depth),
                              agaa_sampleLocation(i), normal, agaa_listedCode(at, normal));
        if (AGAA_GLOSS_WEIGHT != 0u) {
            s.shadingNormal = agaa_listedNormal(at, i);
            s.alpha2 = agaa_listMaterial[at].alpha2;
        }
    }
    return s;
}

// Groups the samples of all complex pixels. All lanes must call it.
void agaa_groupComplexPixels() {
    const uint count = agaa_complexCount;
    for (uint first = 0u; first < count; first += agaa_pixelsAtOnce) {
        uint index = first + agaa_lanePixel(0u);
        bool hasPixel = index < count;
        uint lane = AGAA_COMPLEX_LANE(min(index, 63u)) & 63u;
        agaa_LaneSample s = agaa_noLaneSample();
        if (hasPixel && agaa_laneSample() < AGAA_SAMPLES)
            s = agaa_listedLaneSample(agaa_pixelOf(lane), lane);
        agaa_LaneGroup group = agaa_groupLanes(s, true);
        bool writes = hasPixel && agaa_laneSample() == 0u;
        for (uint a = 0u; a < AGAA_AGGREGATES; ++a) {
            uint mask = agaa_samplesOf(s, group, a);
            if (writes)
                agaa_masks[lane * AGAA_AGGREGATES + a] = mask;
        }
        if (writes) {
            agaa_setAggregates(lane, group.count);
            agaa_count(AGAA_COUNT_JOINED_CLASSES, uint(bitCount(group.joining)));
        }
    }
}
#endif
