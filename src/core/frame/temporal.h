// The previous frame's camera and image, for views that accumulate frames.
#pragma once

#include "agaa_sdk.h"
#include "core/plan/gpu_layout.h"

#include <array>
#include <cstdint>

namespace agaa {

// The images of a view's history take turns.
struct HistoryTurn {
    uint32_t slot = 0;          // that the frame writes, 0 or 1
    uint64_t previousFrame = 0; // recorded before this frame; 0: none
};

// Checks the AgaaTemporalFrame of a frame that is accumulated. Throws Error if there is none or a member is not valid.
void checkTemporalFrame(const AgaaFrame& frame);
// Writes the constants of the checked frame.
void writeTemporal(const AgaaFrame& frame, const HistoryTurn& turn, FrameConstants& out);

// Returns a position of the sequence of agaaGetJitter(). index: < count.
std::array<float, 2> jitterOf(uint64_t index, uint32_t count);

} // namespace agaa
