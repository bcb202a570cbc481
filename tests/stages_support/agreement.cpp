#include "agreement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace agaa::test {

bool isInOrder(const AgaaDeviceCaps& caps) { return caps.flags & AGAA_DEVICE_SOFTWARE; }

void expectSameImage(std::span<const float> got, std::span<const float> expected, const AgaaDeviceCaps& caps,
                     float rounding) {
    ASSERT_EQ(got.size(), expected.size());
    const double bound = isInOrder(caps) ? 0 : double(rounding);
    size_t wrong = 0, first = 0;
    double largest = 0;
    for (size_t i = 0; i < got.size(); ++i) {
        const double difference =
            std::fabs(double(got[i]) - double(expected[i])) / (1 + std::fabs(double(expected[i])));
        if (difference <= bound)
            continue;
        first = wrong++ ? first : i; // also of what is no number
        largest = std::fmax(largest, difference);
    }
    EXPECT_EQ(wrong, 0u) << "of " << got.size() << " values, by " << largest << "; first " << got[first]
                         << " in place of " << expected[first] << ", at " << first;
}

namespace {

bool isAt(const Triangle& a, const Triangle& b) { return std::equal(a.position, a.position + 3, b.position); }

} // namespace

std::vector<Triangle> settleTies(std::vector<Triangle> triangles, const AgaaDeviceCaps& caps, Ties ties) {
    if (isInOrder(caps))
        return triangles;
    for (size_t i = 0; i < triangles.size(); ++i) {
        Triangle& own = triangles[i];
        own.seed = own.seed ? own.seed : uint32_t(i);
        const auto first = std::find_if(triangles.begin(), triangles.begin() + ptrdiff_t(i),
                                        [&](const Triangle& other) { return isAt(other, own); });
        if (first == triangles.begin() + ptrdiff_t(i) || (ties == Ties::Masked && !first->isMasked && !own.isMasked))
            continue;
        own.material = first->material;
        own.isMasked = first->isMasked;
        own.seed = first->seed;
    }
    return triangles;
}

} // namespace agaa::test
