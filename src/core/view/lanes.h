// The choice of the lanes of passes that group the samples of pixels.
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

// Returns the bytes of shared memory that a workgroup needs for the words of its lanes
// (src/shaders/aggregate/lane_words.glsl).
uint32_t laneBytes(AgaaLanes lanes, uint32_t samples);

inline bool hasSampleLanes(AgaaLanes lanes) {
    return lanes == AGAA_LANES_SAMPLE_SHARED || lanes == AGAA_LANES_SAMPLE_SUBGROUP;
}

const char* lanesName(AgaaLanes lanes);

} // namespace agaa
