#include "drawing.h"

#include <algorithm>
#include <cstring>

namespace agaa::conformance {

size_t sceneBytes(const Scene& scene) { return matrixBytes + std::max<size_t>(scene.size(), 1) * sizeof(Vertex); }

void writeScene(void* to, const float* matrix, const Scene& scene) {
    std::memcpy(to, matrix, matrixBytes);
    if (!scene.empty())
        std::memcpy(static_cast<char*>(to) + matrixBytes, scene.data(), scene.size() * sizeof(Vertex));
}

std::vector<DrawRange> drawRanges(const Scene& scene) {
    std::vector<DrawRange> ranges;
    for (uint32_t i = 0; i + 3 <= scene.size(); i += 3) {
        const bool isMasked = scene[i].isMasked != 0;
        if (ranges.empty() || ranges.back().isMasked != isMasked)
            ranges.push_back({i, 0, isMasked});
        ranges.back().count += 3;
    }
    return ranges;
}

void clipFromShading(const AgaaFrame& frame, const Mistakes& mistakes, float* matrix) {
    float projection[16];
    std::copy(frame.projection, frame.projection + 16, projection);
    if (mistakes.changeProjection)
        mistakes.changeProjection(projection);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) {
            float sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += projection[k * 4 + row] * frame.view[column * 4 + k];
            matrix[column * 4 + row] = sum;
        }
}

} // namespace agaa::conformance
