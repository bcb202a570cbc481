// Tests of errors over moving frames with images whose errors are known.
#include "image/tonemap.h"
#include "render/motion_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace harness {
namespace {

constexpr uint32_t width = 24, height = 10;
constexpr float farAway = std::numeric_limits<float>::infinity();

// Returns the light whose tone-mapped value is given.
float lightOf(double shown) {
    const double x = std::pow(shown, 2.2);
    return float(x / (1 - x));
}

// value(x, y): tone-mapped.
template <class Value> Image imageOf(const Value& value) {
    Image image{width, height, {}};
    for (int y = 0; y < int(height); ++y)
        for (int x = 0; x < int(width); ++x)
            image.rgb.insert(image.rgb.end(), 3, lightOf(value(x, y)));
    return image;
}

Image grey(double shown) {
    return imageOf([=](int, int) { return shown; });
}

// All surfaces at distance 5, and moving by `toPrevious` pixels.
MotionImage motionOf(float toPrevious) {
    MotionImage motion{width, height, {}, {}, {}};
    motion.toPrevious.assign(width * height, {toPrevious, 0});
    motion.distance.assign(width * height, 5);
    motion.previousDistance = motion.distance;
    return motion;
}

constexpr uint32_t frameCount = MotionErrorMeter::settling + 6;

// image(frame), reference(frame)
template <class Shown, class Wanted>
MotionError errorOf(const Shown& image, const Wanted& reference, float toPrevious = 0,
                    std::optional<uint32_t> since = {}) {
    Disocclusion disocclusion;
    MotionErrorMeter meter(since);
    for (uint32_t frame = 0; frame < frameCount; ++frame) {
        const MotionImage motion = motionOf(toPrevious);
        disocclusion.add(motion);
        meter.add(image(frame), reference(frame), motion, disocclusion);
    }
    return meter.result();
}

const auto wanted = [](uint32_t) { return imageOf([](int x, int y) { return 0.3 + 0.05 * ((x + y) % 3); }); };

TEST(MotionError, OfTheReferenceItselfIsNone) {
    const MotionError error = errorOf(wanted, wanted);
    EXPECT_EQ(error.frames.size(), frameCount);
    EXPECT_EQ(error.error, 0);
    EXPECT_EQ(error.flicker, 0);
    EXPECT_FALSE(error.ghosting) << "nothing was hidden";
    EXPECT_DOUBLE_EQ(error.sharpness, 1);
    EXPECT_TRUE(error.response.empty());
}

TEST(MotionError, OfConstantErrorHasNoFlicker) {
    const MotionError error = errorOf([](uint32_t) { return grey(0.5); }, [](uint32_t) { return grey(0.4); });
    EXPECT_NEAR(error.error, 0.01, 1e-6);
    EXPECT_NEAR(error.flicker, 0, 1e-6);
    EXPECT_EQ(error.sharpness, 1) << "a grey image has no detail to lose";
}

TEST(MotionError, FlickerIsTheChangeOfTheError) {
    const auto alternating = [](uint32_t frame) { return grey(frame % 2 ? 0.45 : 0.35); };
    const MotionError error = errorOf(alternating, [](uint32_t) { return grey(0.4); });
    EXPECT_NEAR(error.error, 0.0025, 1e-6);
    EXPECT_NEAR(error.flicker, 0.1, 1e-6);
    // The reference may flicker: a light that blinks.
    EXPECT_NEAR(errorOf(alternating, alternating).flicker, 0, 1e-6);
}

TEST(MotionError, FlickerFollowsTheMotion) {
    const auto pattern = [](uint32_t frame) {
        return imageOf([=](int x, int) { return 0.4 + 0.1 * ((x + 24 - int(frame) % 4) % 4 == 0); });
    };
    const auto still = [](uint32_t) { return grey(0.4); };
    EXPECT_NEAR(errorOf(pattern, still, -1).flicker, 0, 1e-6) << "the pattern moves by a pixel a frame";
    EXPECT_GT(errorOf(pattern, still, 0).flicker, 0.06);
}

TEST(MotionError, SharpnessIsTheShareOfDetail) {
    const auto half = [](uint32_t) { return imageOf([](int x, int y) { return 0.325 + 0.025 * ((x + y) % 3); }); };
    EXPECT_NEAR(errorOf(half, wanted).sharpness, 0.5, 1e-5);
    EXPECT_NEAR(errorOf([](uint32_t) { return grey(0.35); }, wanted).sharpness, 0, 1e-5);
}

TEST(MotionError, ResponseIsTheShareOfAChange) {
    const auto light = [](uint32_t frame) { return grey(frame < 10 ? 0.2 : 0.6); };
    const auto late = [](uint32_t frame) { return grey(frame < 10 ? 0.2 : frame < 12 ? 0.3 : 0.6); };
    const MotionError error = errorOf(late, light, 0, 9);
    ASSERT_EQ(error.response.size(), frameCount - 10);
    EXPECT_NEAR(error.response[0], 0.25, 1e-5);
    EXPECT_NEAR(error.response[1], 0.25, 1e-5);
    EXPECT_NEAR(error.response[2], 1, 1e-5);
}

// A surface at distance 2, four pixels wide, moves right by a pixel a frame, or left, in front of one at distance 5 or
// none.
MotionImage passing(uint32_t frame, float behind, bool isLeftward = false) {
    MotionImage motion{width, height, {}, {}, {}};
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t i = 0; i < width; ++i) {
            const uint32_t x = isLeftward ? width - 1 - i : i;
            const bool isFront = x >= frame && x < frame + 4;
            motion.toPrevious.push_back({isFront ? isLeftward ? 1 : -1 : 0, 0});
            motion.distance.push_back(isFront ? 2 : behind);
            motion.previousDistance.push_back(motion.distance.back());
        }
    return motion;
}

TEST(Disocclusion, IsWhatThePassingSurfaceLeaves) {
    for (const bool isLeftward : {false, true})
        for (const float behind : {5.0f, farAway}) {
            Disocclusion disocclusion;
            for (uint32_t frame = 0; frame <= 12; ++frame)
                disocclusion.add(passing(frame, behind, isLeftward));
            for (uint32_t x = 1; x < width; ++x) {
                const bool isUncovered = x >= 12 - Disocclusion::frames && x < 12;
                const uint32_t at = isLeftward ? width - 1 - x : x;
                EXPECT_EQ(disocclusion.isNew(3 * width + at), isUncovered) << x;
                EXPECT_EQ(disocclusion.wasVisible(3 * width + at), x != 11) << x;
            }
            EXPECT_NEAR(disocclusion.share(), double(Disocclusion::frames) / width, 0.05);
        }
}

TEST(Disocclusion, OutsideOfTheImageIsHidden) {
    Disocclusion disocclusion;
    for (int frame = 0; frame < 3; ++frame)
        disocclusion.add(motionOf(1.0f)); // moves left: the last column comes from outside
    EXPECT_FALSE(disocclusion.wasVisible(width - 1));
    EXPECT_TRUE(disocclusion.isNew(width - 2));
    EXPECT_FALSE(disocclusion.isNew(width - 3));
}

TEST(MotionError, GhostsAreErrorsOfNewSurfaces) {
    Disocclusion disocclusion;
    MotionErrorMeter meter;
    for (uint32_t frame = 0; frame < 16; ++frame) {
        const MotionImage motion = passing(frame, 5);
        disocclusion.add(motion);
        // The image shows 0.2 too much in the pixels that the surface left in the last four frames.
        const Image image = imageOf([=](int x, int) { return x < int(frame) && x + 4 >= int(frame) ? 0.6 : 0.4; });
        meter.add(image, grey(0.4), motion, disocclusion);
    }
    const MotionError error = meter.result();
    ASSERT_TRUE(error.ghosting);
    EXPECT_NEAR(*error.ghosting, 0.04 / 2, 1e-3);
}

} // namespace
} // namespace harness
