#include "compose.h"

#include <algorithm>
#include <cmath>

namespace viewer {

uint32_t splitColumn(uint32_t width, double split) {
    return uint32_t(std::clamp(std::lround(split * width), 0L, long(width)));
}

std::vector<harness::Pixel> composed(const harness::Image& a, const harness::Image* b, const ViewerState& state) {
    if (state.mode == Mode::A || !b || b->width != a.width || b->height != a.height)
        return displayPixels(a);
    if (state.mode == Mode::Difference)
        return differencePixels(a, *b, float(state.gain));
    std::vector<harness::Pixel> pixels = displayPixels(*b);
    if (state.mode == Mode::B)
        return pixels;
    const std::vector<harness::Pixel> left = displayPixels(a);
    const uint32_t column = splitColumn(a.width, state.split);
    for (size_t row = 0; row < a.height; ++row)
        std::copy_n(left.begin() + ptrdiff_t(row * a.width), column, pixels.begin() + ptrdiff_t(row * a.width));
    return pixels;
}

} // namespace viewer
