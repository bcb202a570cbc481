#include "drawing.h"

#include <algorithm>

namespace agaa::conformance {

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
