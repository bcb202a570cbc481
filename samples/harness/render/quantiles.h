// Quantiles of a few measurements, by linear interpolation between ranks, and how far their median can be trusted.
#pragma once

#include <algorithm>
#include <cmath>
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

struct MedianBounds {
    double low = 0, high = 0;
    double confidence = 0; // that the median of what was measured lies between them
};

// The nearest two measurements that reach the confidence wanted, by the binomial distribution of how many lie below
// the median, whatever the measurements' own distribution; the outermost two where they are too few.
inline MedianBounds medianBounds(std::vector<double> values, double wanted = 0.95) {
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    const size_t n = values.size();
    double term = std::pow(0.5, double(n)), tail = term; // that at most k lie below
    size_t k = 0;
    while (2 * (k + 1) + 1 < n) {
        term *= double(n - k) / double(k + 1);
        if (1 - 2 * (tail + term) < wanted)
            break;
        tail += term;
        ++k;
    }
    return {values[k], values[n - 1 - k], std::max(1 - 2 * tail, 0.0)};
}

} // namespace harness
