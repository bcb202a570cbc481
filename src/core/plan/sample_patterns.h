// Where the samples of a pixel lie.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace agaa {

struct SamplePosition {
    float x, y; // in the pixel, [0;1), y down
};

// Where a device rasterises the samples of a texel; as many as it has.
std::vector<SamplePosition> standardPositions(uint32_t hwSamples);

// Sample i of a target of scaleX x scaleY sub-pixels, each with samples at these positions:
// i = (sy scaleX + sx) hwSamples + s.
using SamplePositions = std::array<SamplePosition, 128>;
SamplePositions samplePositions(std::span<const SamplePosition> texel, uint32_t scaleX,
                                uint32_t scaleY);
SamplePositions samplePositions(std::span<const float> pairs); // x, y

} // namespace agaa
