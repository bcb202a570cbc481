// What tests compare where programs round in their own way, and which draws they settle there.
#include "agreement.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace agaa::test {
namespace {

AgaaDeviceCaps capsOf(uint64_t flags) {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    caps.flags = flags;
    return caps;
}
const AgaaDeviceCaps software = capsOf(AGAA_DEVICE_SOFTWARE), hardware = capsOf(0);
const std::vector<float> image = {1, 2, 3};

TEST(Agreement, BitsCountOnSoftwareRasterisers) {
    static const std::vector<float> next = {1, 2, std::nextafter(3.0f, 4.0f)};
    expectSameImage(image, image, software);
    expectSameImage(next, image, hardware);
    EXPECT_NONFATAL_FAILURE(expectSameImage(next, image, software), "1");
}

TEST(Agreement, MoreThanRoundingAndWhatIsNoNumberFail) {
    static const std::vector<float> within = {1 + 3e-5f, 2, 3}, beyond = {1 + 5e-5f, 2, 3};
    static const std::vector<float> none = {std::numeric_limits<float>::quiet_NaN(), 2, 3};
    expectSameImage(within, image, hardware); // 2e-5 of 1 and of the value
    EXPECT_NONFATAL_FAILURE(expectSameImage(beyond, image, hardware), "1");
    EXPECT_NONFATAL_FAILURE(expectSameImage(none, image, hardware), "nan");
}

TEST(Agreement, DrawsAtOnePlaceAreSettledWhereTheirOrderIsFree) {
    std::vector<Triangle> list(4);
    for (size_t i = 0; i < list.size(); ++i) {
        list[i].position[0].x = i < 2 ? 0.0f : 1.0f; // two pairs
        list[i].material.diffuse.x = 0.1f * float(i + 1);
    }
    list[1].isMasked = true;
    const auto shade = [](const std::vector<Triangle>& triangles, size_t i) { return triangles[i].material.diffuse.x; };
    EXPECT_EQ(shade(settleTies(list, software), 1), shade(list, 1));
    const std::vector<Triangle> masked = settleTies(list, hardware), all = settleTies(list, hardware, Ties::All);
    EXPECT_EQ(shade(masked, 1), shade(list, 0));
    EXPECT_FALSE(masked[1].isMasked);
    EXPECT_EQ(masked[1].seed, masked[0].seed);
    EXPECT_EQ(shade(masked, 3), shade(list, 3)) << "the stencil test keeps the first of opaque draws";
    EXPECT_EQ(shade(all, 3), shade(list, 2));
}

} // namespace
} // namespace agaa::test
