// Room for fragments from a count of them.
#include "render/fragment_capacity.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

TEST(FragmentRoom, IsAnEighthMoreThanAFrameNeeds) {
    EXPECT_EQ(capacityForFragments(10 * 640 * 360, 640, 360), 11.25f);
    EXPECT_EQ(capacityForFragments(8, 2, 1), 4.5f);
}

TEST(FragmentRoom, IsInTheRangeThatViewsTake) {
    EXPECT_EQ(capacityForFragments(0, 640, 360), 1.0f);
    EXPECT_EQ(capacityForFragments(1, 640, 360), 1.0f);
    EXPECT_EQ(capacityForFragments(3, 2, 1), 1.6875f);
    EXPECT_EQ(capacityForFragments(1000, 1, 1), 256.0f);
    EXPECT_EQ(capacityForFragments(~uint64_t(0), 16384, 16384), 256.0f);
}

// The lists have room for pixels times fragmentsPerPixel, a float: rounding must take less than the margin.
TEST(FragmentRoom, HoldsTheFragmentsThatWereCounted) {
    for (const uint32_t side : {257u, 1021u, 4093u, 16381u})
        for (const uint64_t extra : {uint64_t(0), uint64_t(1), uint64_t(side) * side / 3}) {
            const uint64_t pixels = uint64_t(side) * side, fragments = 7 * pixels + extra;
            const auto room = uint64_t(double(pixels) * double(capacityForFragments(fragments, side, side)));
            EXPECT_GE(room, fragments + fragments / 9) << side << ' ' << extra;
        }
}

} // namespace
} // namespace harness
