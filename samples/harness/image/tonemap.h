// The tone mapping of all pictures of the project and of the metric mseTm.
#pragma once

#include <cmath>

namespace harness {

// Maps x to x/(1+x), then ^(1/2.2). Negative light cannot be displayed and becomes black.
inline double toneMap(double linear) {
    const double x = linear > 0 ? linear : 0;
    return std::pow(x / (1 + x), 1 / 2.2);
}

} // namespace harness
