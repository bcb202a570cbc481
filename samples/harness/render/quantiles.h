// Quantiles of a few measurements by linear interpolation between ranks, and the confidence interval of their median.
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
    double confidence = 0; // probability that the median of the distribution lies in the interval
};

// Returns the nearest two measurements that reach the requested confidence, or the outermost two if there are too few.
// The number of measurements below the median has a binomial distribution, whatever the distribution of the
// measurements.
inline MedianBounds medianBounds(std::vector<double> values, double wanted = 0.95) {
    if (values.empty())
        return {};
    std::sort(values.begin(), values.end());
    const size_t n = values.size();
    double term = std::pow(0.5, double(n)), tail = term; // tail: probability that at most k lie below
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
