// Quantiles of a few measurements, by linear interpolation between ranks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace harness {

inline double quantile(std::vector<double> values, double fraction) {
    if (values.empty())
        return 0;
    std::sort(values.begin(), values.end());
    const double rank = fraction * double(values.size() - 1);
    const size_t below = size_t(rank);
    const size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (rank - double(below)) * (values[above] - values[below]);
}

} // namespace harness
