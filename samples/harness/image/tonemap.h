// The one tone mapping of the project's pictures and of the mseTm metric.
#pragma once

#include <cmath>

namespace harness {

// x/(1+x), then ^(1/2.2). Negative light cannot be displayed and counts as black.
inline double toneMap(double linear) {
    const double x = linear > 0 ? linear : 0;
    return std::pow(x / (1 + x), 1 / 2.2);
}

} // namespace harness
