// The choice of the lanes of passes that compare the samples of pixels, and of the memory of passes that merge
// fragments.
#pragma once

#include "agaa_sdk.h"

#include <cstdint>
#include <string>

namespace agaa {

struct LaneChoice {
    AgaaLanes lanes = AGAA_LANES_AUTO; // AUTO: the forced value cannot run
    std::string reason;                // one sentence
};

// Returns the forced choice or, with AUTO, the best that the device runs.
LaneChoice chooseLanes(const AgaaDeviceCaps& caps, uint32_t samples, uint32_t forced);

struct SurfaceMemory {
    bool isShared = false; // memory of the workgroup, otherwise an array of each lane
    bool canRun = true;    // false: the device lacks the memory that is forced
    std::string reason;    // one sentence
};

// Returns where a pass with one lane per pixel keeps the surfaces that fragments merge into: with AUTO in the fastest
// memory of the device, and with a value that has one lane per sample in shared memory.
// bytes    Size of the surfaces of a workgroup.
SurfaceMemory chooseSurfaceMemory(const AgaaDeviceCaps& caps, uint32_t bytes, uint32_t forced);

// Returns the choice for passes over lists of fragments, as chooseLanes() does. All devices have their shared memory.
// groupsFragments   The passes cluster fragments.
LaneChoice chooseListLanes(const AgaaDeviceCaps& caps, bool groupsFragments, uint32_t forced);

// Returns the bytes of shared memory that a workgroup needs for the words of its lanes
// (src/shaders/aggregate/lane_words.glsl).
uint32_t laneBytes(AgaaLanes lanes, uint32_t samples);

inline bool hasSampleLanes(AgaaLanes lanes) {
    return lanes == AGAA_LANES_SAMPLE_SHARED || lanes == AGAA_LANES_SAMPLE_SUBGROUP;
}

const char* lanesName(AgaaLanes lanes);

} // namespace agaa
