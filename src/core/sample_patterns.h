// Where the samples of a pixel lie.
#pragma once

#include <array>
#include <cstdint>

namespace agaa {

struct SamplePosition {
    float x, y; // in the pixel, [0;1), y down
};

// Sample i of a target of scaleX x scaleY sub-pixels with the standard positions of hwSamples each:
// i = (sy scaleX + sx) hwSamples + s.
std::array<SamplePosition, 32> samplePositions(uint32_t hwSamples, uint32_t scaleX,
                                               uint32_t scaleY);

} // namespace agaa
