#include "error_of.h"
#include "flip_direct.h"
#include "image/metrics.h"
#include "image/tonemap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

using harness::compareImages;
using harness::Image;
using harness::Metrics;

namespace {

Image constant(uint32_t width, uint32_t height, float value) {
    return {width, height, std::vector<float>(size_t(width) * height * 3, value)};
}

} // namespace

TEST(ToneMap, KnownValues) {
    EXPECT_EQ(harness::toneMap(0), 0);
    EXPECT_EQ(harness::toneMap(-5), 0);
    EXPECT_NEAR(harness::toneMap(1), std::exp(std::log(0.5) / 2.2), 1e-15);
    EXPECT_NEAR(harness::toneMap(3), 0.877424, 1e-6); // 0.75^(1/2.2)
    EXPECT_LE(harness::toneMap(3e38), 1);
    EXPECT_GT(harness::toneMap(3e38), 0.999999);
}

TEST(Metrics, IdenticalImages) {
    const Metrics m = compareImages(constant(6, 4, 0.7f), constant(6, 4, 0.7f));
    EXPECT_EQ(m.mse, 0);
    EXPECT_EQ(m.mseTm, 0);
    EXPECT_EQ(m.relMse, 0);
    EXPECT_TRUE(std::isinf(m.psnr) && m.psnr > 0);
    EXPECT_EQ(m.flip, 0);
    EXPECT_EQ(m.flipP95, 0);
    EXPECT_EQ(m.maxAbs, 0);
    EXPECT_EQ(m.psnrPeak, 1);
    EXPECT_EQ(m.pixelsPerDegree, 67);
}

// Reference 1, test 3: after x/(1+x) these are 1/2 and 3/4.
TEST(Metrics, ConstantImagesInClosedForm) {
    const Metrics m = compareImages(constant(5, 3, 1), constant(5, 3, 3));
    const double mapped = std::pow(0.75, 1 / 2.2) - std::pow(0.5, 1 / 2.2);
    EXPECT_DOUBLE_EQ(m.mse, 4);
    EXPECT_NEAR(m.mseTm, mapped * mapped, 1e-15);
    EXPECT_NEAR(m.relMse, 4 / 1.01, 1e-12);
    EXPECT_NEAR(m.psnr, -20 * std::log10(mapped), 1e-9);
    EXPECT_DOUBLE_EQ(m.maxAbs, 2);
}

TEST(Metrics, RelativeErrorDividesByTheReference) {
    EXPECT_NEAR(compareImages(constant(2, 2, 3), constant(2, 2, 1)).relMse, 4 / 9.01, 1e-12);
    EXPECT_NEAR(compareImages(constant(2, 2, 0), constant(2, 2, 0.5f)).relMse, 25, 1e-12);
}

// One channel of one of 8 x 4 pixels differs by 0.5: 0.25 / 96.
TEST(Metrics, OneChannelOfOnePixel) {
    const Image reference = constant(8, 4, 0.5f);
    Image test = reference;
    test.rgb[3 * 13 + 1] = 1.f;
    const Metrics m = compareImages(reference, test);
    const double mapped = std::pow(0.5, 1 / 2.2) - std::pow(1.0 / 3, 1 / 2.2);
    EXPECT_DOUBLE_EQ(m.mse, 0.25 / 96);
    EXPECT_NEAR(m.mseTm, mapped * mapped / 96, 1e-15);
    EXPECT_NEAR(m.relMse, 0.25 / 0.26 / 96, 1e-12);
    EXPECT_NEAR(m.psnr, 10 * std::log10(96 / (mapped * mapped)), 1e-9);
    EXPECT_DOUBLE_EQ(m.maxAbs, 0.5);
}

// Chosen so that the tone-mapped difference is 0.1: 20 dB below a peak of 1.
TEST(Metrics, PsnrOfATenth) {
    const double p = std::pow(0.6, 2.2), q = std::pow(0.5, 2.2);
    const Metrics m = compareImages(constant(4, 4, float(p / (1 - p))), constant(4, 4, float(q / (1 - q))));
    EXPECT_NEAR(m.mseTm, 0.01, 1e-8);
    EXPECT_NEAR(m.psnr, 20, 1e-5);
}

TEST(Metrics, NegativeLightCountsInLinearErrorOnly) {
    const Metrics m = compareImages(constant(3, 3, 0), constant(3, 3, -2));
    EXPECT_DOUBLE_EQ(m.mse, 4);
    EXPECT_DOUBLE_EQ(m.maxAbs, 2);
    EXPECT_EQ(m.mseTm, 0);
    EXPECT_EQ(m.flip, 0);
    EXPECT_TRUE(std::isinf(m.psnr));
}

TEST(Metrics, FlipIsTakenOfToneMappedImages) {
    Image reference{12, 9, {}}, test{12, 9, {}};
    for (size_t i = 0; i < reference.pixelCount() * 3; ++i) {
        reference.rgb.push_back(float(i % 11) * 0.4f);
        test.rgb.push_back(float(i % 7) * 0.5f);
    }
    Image a = reference, b = test;
    for (Image* image : {&a, &b})
        for (float& v : image->rgb)
            v = std::pow(v / (1 + v), 1 / 2.2f);
    std::vector<double> errors = directFlip(a, b, 67);
    double mean = 0;
    for (double error : errors)
        mean += error / double(errors.size());
    std::sort(errors.begin(), errors.end());
    // 0.95 * 107 = 101.65
    const double p95 = errors[101] + 0.65 * (errors[102] - errors[101]);

    const Metrics m = compareImages(reference, test);
    EXPECT_NEAR(m.flip, mean, 1e-5);
    EXPECT_NEAR(m.flipP95, p95, 1e-5);
}

TEST(Metrics, OnePixel) {
    const Metrics m = compareImages(constant(1, 1, 0), constant(1, 1, 1));
    EXPECT_DOUBLE_EQ(m.mse, 1);
    EXPECT_NEAR(m.relMse, 100, 1e-9);
    EXPECT_GT(m.flip, 0.5);
    EXPECT_EQ(m.flip, m.flipP95);
}

TEST(Metrics, SizesMustAgree) {
    const std::string error = errorOf([] { compareImages(constant(4, 3, 0), constant(3, 4, 0)); });
    EXPECT_NE(error.find("4x3"), std::string::npos) << error;
    EXPECT_NE(error.find("3x4"), std::string::npos) << error;
}

TEST(Metrics, ValuesMustBeFinite) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (float bad : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}) {
        Image image = constant(4, 3, 0.5f);
        image.rgb[3 * (1 * 4 + 2) + 2] = bad;
        const std::string inTest = errorOf([&] { compareImages(constant(4, 3, 0.5f), image); });
        EXPECT_EQ(inTest, "The test image has a value that is not finite in channel B of pixel "
                          "(2, 1).");
        const std::string inReference = errorOf([&] { compareImages(image, constant(4, 3, 0.5f)); });
        EXPECT_NE(inReference.find("The reference image"), std::string::npos) << inReference;
    }
}

TEST(Metrics, ImagesMustHoldWhatTheirSizeSays) {
    Image broken = constant(4, 3, 0);
    broken.rgb.pop_back();
    EXPECT_NE(errorOf([&] { compareImages(broken, constant(4, 3, 0)); }), "");
    EXPECT_NE(errorOf([] { compareImages(Image{}, Image{}); }), "");
}
