// Bounds of a median against all ways in which measurements can lie below and above it.
#include "render/quantiles.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>

namespace harness {
namespace {

// Of n measurements, each below the median in half of all cases: in how many cases the median lies between the one
// of rank `low` and the one of rank n - 1 - low.
double covered(uint32_t n, uint32_t low) {
    uint32_t inside = 0;
    for (uint32_t below = 0; below < 1u << n; ++below) {
        const uint32_t count = uint32_t(std::popcount(below));
        inside += count > low && count < n - low;
    }
    return double(inside) / double(1u << n);
}

TEST(MedianBounds, AreTheNearestThatCoverEnough) {
    for (uint32_t n = 1; n <= 16; ++n) {
        std::vector<double> values(n);
        std::iota(values.begin(), values.end(), 0.0);
        std::reverse(values.begin(), values.end());
        const MedianBounds bounds = medianBounds(values, 0.95);
        const uint32_t low = uint32_t(bounds.low);
        EXPECT_EQ(bounds.high, double(n - 1 - low));
        EXPECT_NEAR(bounds.confidence, covered(n, low), 1e-12) << n;
        if (low > 0) {
            EXPECT_GE(bounds.confidence, 0.95) << n;
        }
        if (low + 1 < n - 1 - (low + 1)) {
            EXPECT_LT(covered(n, low + 1), 0.95) << n << ": nearer ones would do";
        }
    }
    EXPECT_EQ(medianBounds({}).confidence, 0);
}

TEST(Quantiles, LieBetweenRanks) {
    EXPECT_EQ(quantile({4, 1, 3}, 0.5), 3);
    EXPECT_EQ(quantile({1, 2}, 0.5), 1.5);
    EXPECT_EQ(quantile({5}, 0.95), 5);
}

} // namespace
} // namespace harness
