#include "core/plan/sample_patterns.h"

#include "core/view/resolved_view.h"

#include <algorithm>
#include <cmath>

namespace agaa {

constexpr uint32_t mostStandardSamples = 16;

// The standard sample locations of Vulkan and Direct3D, in sixteenths of a pixel.
static const uint8_t (*standardPattern(uint32_t samples))[2] {
    static constexpr uint8_t one[][2] = {{8, 8}};
    static constexpr uint8_t two[][2] = {{12, 12}, {4, 4}};
    static constexpr uint8_t four[][2] = {{6, 2}, {14, 6}, {2, 10}, {10, 14}};
    static constexpr uint8_t eight[][2] = {{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}};
    static constexpr uint8_t sixteen[][2] = {{9, 9},  {7, 5}, {5, 10}, {12, 7}, {3, 6}, {10, 13}, {13, 11}, {11, 3},
                                             {6, 14}, {8, 1}, {4, 2},  {2, 12}, {0, 8}, {15, 4},  {14, 15}, {1, 0}};
    switch (samples) {
    case 2:
        return two;
    case 4:
        return four;
    case 8:
        return eight;
    case 16:
        return sixteen;
    default:
        return one;
    }
}

std::vector<SamplePosition> standardPositions(uint32_t hwSamples) {
    std::vector<SamplePosition> positions;
    const uint32_t count = std::min(hwSamples, mostStandardSamples);
    const auto* pattern = standardPattern(count);
    for (uint32_t i = 0; i < hwSamples; ++i) {
        const uint8_t* at = pattern[i % count];
        const float row = float(i / count); // of the pixel's parts, each with one pattern
        positions.push_back({float(at[0]) / 16.0f, (row + float(at[1]) / 16.0f) * float(count) / float(hwSamples)});
    }
    return positions;
}

namespace {

// The part of the pixel in which a layer has its samples. The parts are those of a scaled target.
struct Parts {
    uint32_t x, y;
};
Parts partsOf(const ResolvedView& view) {
    const uint32_t x = view.layers >= 4 ? 2 : 1;
    return {x, view.layers / x};
}

// All layers have the same locations in a texel, around its centre, and each layer moves the scene by its own offset.
// Locations are rounded down to sixteenths; layerCentres() makes up for it.
float locationInPart(float at, uint32_t parts) { return std::floor(16 * (0.5f + (at - 0.5f) / float(parts))) / 16; }

// Returns by how much the locations are rounded on average.
SamplePosition roundingOf(const ResolvedView& view) {
    const Parts parts = partsOf(view);
    SamplePosition sum{};
    for (const SamplePosition& at : standardPositions(view.hwSamples)) {
        sum.x += 0.5f + (at.x - 0.5f) / float(parts.x) - locationInPart(at.x, parts.x);
        sum.y += 0.5f + (at.y - 0.5f) / float(parts.y) - locationInPart(at.y, parts.y);
    }
    return {sum.x / float(view.hwSamples), sum.y / float(view.hwSamples)};
}

// Offsets of layers for samples that lie where the device has them, relative to the distance of the outermost sample
// from the border of the pixel. No two samples of a pattern of 2, 4 or 8 have a row or a column in common.
const int8_t (*offsetPattern(uint32_t layers))[2] { // in eighths
    static constexpr int8_t two[][2] = {{-4, -4}, {4, 4}};
    static constexpr int8_t four[][2] = {{-6, -2}, {-2, 6}, {2, -6}, {6, 2}};
    static constexpr int8_t eight[][2] = {{-7, 3}, {-5, -3}, {-3, 7}, {-1, -5}, {1, 1}, {3, 5}, {5, -7}, {7, -1}};
    return layers == 2 ? two : layers == 4 ? four : eight;
}

float borderOf(uint32_t hwSamples) {
    float border = 0.5f;
    for (const SamplePosition& at : standardPositions(hwSamples))
        border = std::min({border, at.x, 1 - at.x, at.y, 1 - at.y});
    return border;
}

} // namespace

std::vector<SamplePosition> texelPositions(const ResolvedView& view) {
    std::vector<SamplePosition> positions = standardPositions(view.hwSamples);
    const Parts parts = partsOf(view);
    for (SamplePosition& at : positions)
        if (view.placesSamples)
            at = {locationInPart(at.x, parts.x), locationInPart(at.y, parts.y)};
    return positions;
}

std::vector<SamplePosition> layerCentres(const ResolvedView& view) {
    std::vector<SamplePosition> centres;
    const Parts parts = partsOf(view);
    const SamplePosition rounding = view.placesSamples ? roundingOf(view) : SamplePosition{};
    for (uint32_t layer = 0; layer < view.layers; ++layer) {
        if (view.layers == 1) {
            centres.push_back({0.5f, 0.5f});
        } else if (view.placesSamples) {
            centres.push_back({(float(layer % parts.x) + 0.5f) / float(parts.x) + rounding.x,
                               (float(layer / parts.x) + 0.5f) / float(parts.y) + rounding.y});
        } else {
            const int8_t* offset = offsetPattern(view.layers)[layer];
            const float border = borderOf(view.hwSamples);
            centres.push_back({0.5f + border * float(offset[0]) / 8, 0.5f + border * float(offset[1]) / 8});
        }
    }
    return centres;
}

SamplePositions samplePositions(std::span<const SamplePosition> texel, uint32_t scaleX, uint32_t scaleY) {
    SamplePositions positions{};
    const uint32_t count = uint32_t(texel.size());
    for (uint32_t i = 0; i < count * scaleX * scaleY && i < positions.size(); ++i) {
        const uint32_t group = i / count;
        const SamplePosition& at = texel[i % count];
        positions[i] = {(float(group % scaleX) + at.x) / float(scaleX), (float(group / scaleX) + at.y) / float(scaleY)};
    }
    return positions;
}

SamplePositions samplePositions(std::span<const SamplePosition> texel, const ResolvedView& view) {
    if (view.layers == 1)
        return samplePositions(texel, view.scaleX, view.scaleY);
    SamplePositions positions{};
    uint32_t i = 0;
    for (const SamplePosition& centre : layerCentres(view))
        for (const SamplePosition& at : texel)
            positions.at(i++) = {at.x + centre.x - 0.5f, at.y + centre.y - 0.5f};
    return positions;
}

SamplePositions samplePositions(std::span<const float> pairs) {
    SamplePositions positions{};
    for (size_t i = 0; i < positions.size() && 2 * i + 1 < pairs.size(); ++i)
        positions[i] = {pairs[2 * i], pairs[2 * i + 1]};
    return positions;
}

SamplePositions samplePositions(const ResolvedView& view) {
    return view.samplePositions.empty() ? samplePositions(texelPositions(view), view)
                                        : samplePositions(view.samplePositions);
}

} // namespace agaa
