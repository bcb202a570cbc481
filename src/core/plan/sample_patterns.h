// Positions of the samples of a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace agaa {

struct ResolvedView;

struct SamplePosition {
    float x, y; // in the pixel, [0;1), y down
};

// Returns the positions at which a device rasterises the samples of a texel, a power of two. Standards define at most
// 16 of them; plans for more, which no device executes, divide the texel into rows.
std::vector<SamplePosition> standardPositions(uint32_t hwSamples);

// Returns the positions in a texel at which the view rasterises samples: those that the executor sets, in sixteenths
// of the texel, or the standard ones.
std::vector<SamplePosition> texelPositions(const ResolvedView& view);

// Returns for each layer of the view the point of the pixel that its texel's centre shows (AGAA section 4.4).
std::vector<SamplePosition> layerCentres(const ResolvedView& view);

// Returns the samples of a target with scaleX x scaleY texels per pixel, each with samples at these positions. The
// index is (sy scaleX + sx) hwSamples + s.
using SamplePositions = std::array<SamplePosition, 128>;
SamplePositions samplePositions(std::span<const SamplePosition> texel, uint32_t scaleX, uint32_t scaleY);
// Returns those of the view's target. In layers the index is layer hwSamples + s.
SamplePositions samplePositions(std::span<const SamplePosition> texel, const ResolvedView& view);
SamplePositions samplePositions(std::span<const float> pairs); // x, y
// Returns the samples of the view: those that the host set, or those of a device with the standard locations.
SamplePositions samplePositions(const ResolvedView& view);

} // namespace agaa
