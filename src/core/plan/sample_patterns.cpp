#include "core/plan/sample_patterns.h"

#include "core/view/resolved_view.h"

#include <algorithm>

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

SamplePositions samplePositions(std::span<const float> pairs) {
    SamplePositions positions{};
    for (size_t i = 0; i < positions.size() && 2 * i + 1 < pairs.size(); ++i)
        positions[i] = {pairs[2 * i], pairs[2 * i + 1]};
    return positions;
}

SamplePositions samplePositions(const ResolvedView& view) {
    return view.samplePositions.empty() ? samplePositions(standardPositions(view.hwSamples), view.scaleX, view.scaleY)
                                        : samplePositions(view.samplePositions);
}

} // namespace agaa
