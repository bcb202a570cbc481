#include "flip_direct.h"
#include "image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using harness::flipErrorMap;
using harness::Image;
using harness::percentile;

namespace {

constexpr double pixelsPerDegree = 67;

Image constant(uint32_t width, uint32_t height, float r, float g, float b) {
    Image image{width, height, {}};
    for (size_t i = 0; i < image.pixelCount(); ++i)
        image.rgb.insert(image.rgb.end(), {r, g, b});
    return image;
}

Image noise(uint32_t width, uint32_t height, unsigned seed, float low, float high) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(low, high);
    Image image{width, height, std::vector<float>(size_t(width) * height * 3)};
    for (float& v : image.rgb)
        v = value(random);
    return image;
}

// Vertical and slanted thin bars on a gradient: what anti-aliasing is about.
Image bars(uint32_t width, uint32_t height, float shift) {
    Image image = constant(width, height, 0, 0, 0);
    for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
            float* rgb = &image.rgb[3 * (size_t(y) * width + x)];
            const float bar = std::fmod(float(x) + 0.3f * float(y) + shift, 7.f) < 1.5f ? 1.f : 0.f;
            rgb[0] = std::max(bar, float(x) / float(width));
            rgb[1] = std::max(0.8f * bar, float(y) / float(height));
            rgb[2] = 0.2f + 0.5f * bar;
        }
    }
    return image;
}

double mean(const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

void expectLikeDirect(const Image& a, const Image& b, double ppd) {
    const std::vector<float> fast = flipErrorMap(a, b, ppd);
    const std::vector<double> direct = directFlip(a, b, ppd);
    ASSERT_EQ(fast.size(), direct.size());
    double largest = 0;
    for (size_t i = 0; i < fast.size(); ++i) {
        EXPECT_NEAR(fast[i], direct[i], 2e-5) << "pixel " << i;
        largest = std::max(largest, direct[i]);
    }
    EXPECT_GT(largest, 0.01) << "the two images must differ for this to show anything";
}

} // namespace

TEST(Flip, IdenticalImagesHaveNoError) {
    const Image image = bars(23, 17, 0);
    for (float error : flipErrorMap(image, image, pixelsPerDegree))
        EXPECT_EQ(error, 0.f);
}

// HyAB of black and white is 100, that of Hunt-adjusted green and blue 203.4; so
// e = 100^0.7 = 25.119, cmax = 41.28 and the error is 0.95 + 0.05 (e/cmax - 0.4)/0.6 = 0.9674.
// The feature term vanishes: neither image has features.
TEST(Flip, BlackAgainstWhite) {
    const auto errors = flipErrorMap(constant(9, 5, 0, 0, 0), constant(9, 5, 1, 1, 1), pixelsPerDegree);
    for (float error : errors)
        EXPECT_NEAR(error, 0.9674, 1e-3);
}

// The pair of colours the paper's scale is normalised to.
TEST(Flip, GreenAgainstBlueIsOne) {
    const auto errors = flipErrorMap(constant(4, 4, 0, 1, 0), constant(4, 4, 0, 0, 1), pixelsPerDegree);
    for (float error : errors)
        EXPECT_NEAR(error, 1.0, 1e-6);
}

// Two greys below the knee: error = 0.95 |L1-L2|^0.7 / (0.4 cmax), L = 116 cbrt(Y) - 16.
TEST(Flip, GreysFollowTheLightnessDifference) {
    const auto lightness = [](double encoded) {
        return 116 * std::cbrt(std::pow((encoded + 0.055) / 1.055, 2.4)) - 16;
    };
    const double expected = 0.95 * std::pow(lightness(0.6) - lightness(0.5), 0.7) / (0.4 * std::pow(203.4, 0.7));
    const auto errors =
        flipErrorMap(constant(3, 3, 0.5f, 0.5f, 0.5f), constant(3, 3, 0.6f, 0.6f, 0.6f), pixelsPerDegree);
    for (float error : errors)
        EXPECT_NEAR(error, expected, 1e-3);
}

TEST(Flip, LikeTheDirectFormOnNoise) {
    expectLikeDirect(noise(31, 22, 1, 0.f, 1.f), noise(31, 22, 2, 0.f, 1.f), pixelsPerDegree);
}

TEST(Flip, LikeTheDirectFormOnSmallDifferences) {
    Image a = bars(29, 26, 0);
    Image b = a;
    const Image grain = noise(29, 26, 3, -0.05f, 0.05f);
    for (size_t i = 0; i < b.rgb.size(); ++i)
        b.rgb[i] = std::clamp(b.rgb[i] + grain.rgb[i], 0.f, 1.f);
    expectLikeDirect(a, b, pixelsPerDegree);
}

TEST(Flip, LikeTheDirectFormOnShiftedBars) {
    expectLikeDirect(bars(40, 12, 0), bars(40, 12, 2), pixelsPerDegree);
    expectLikeDirect(bars(12, 40, 0), bars(12, 40, 2), 25);
}

// Smaller than every kernel, down to one row, one column and one pixel.
TEST(Flip, LikeTheDirectFormOnTinyImages) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 7u}, {7u, 1u}, {3u, 2u}})
        expectLikeDirect(noise(width, height, 4, 0.f, 1.f), noise(width, height, 5, 0.f, 1.f), pixelsPerDegree);
}

TEST(Flip, IsSymmetric) {
    const Image a = bars(20, 20, 0), b = noise(20, 20, 6, 0.f, 1.f);
    EXPECT_EQ(flipErrorMap(a, b, pixelsPerDegree), flipErrorMap(b, a, pixelsPerDegree));
}

TEST(Flip, ClampsToDisplayRange) {
    const Image a = constant(5, 5, 0.f, 0.5f, 1.f), b = constant(5, 5, -3.f, 0.5f, 8.f);
    for (float error : flipErrorMap(a, b, pixelsPerDegree))
        EXPECT_EQ(error, 0.f);
}

// A point is blurred away by the eye when it covers a smaller angle.
TEST(Flip, ASpeckMattersLessFromFurtherAway) {
    const Image a = constant(41, 41, 0.5f, 0.5f, 0.5f);
    Image b = a;
    std::fill_n(b.rgb.begin() + 3 * (20 * 41 + 20), 3, 0.7f);
    const double near = mean(flipErrorMap(a, b, 20)), far = mean(flipErrorMap(a, b, 67));
    EXPECT_GT(near, 0);
    const auto peak = [&](double ppd) {
        const auto errors = flipErrorMap(a, b, ppd);
        return *std::max_element(errors.begin(), errors.end());
    };
    EXPECT_GT(peak(20), peak(67));
    EXPECT_GT(far, 0);
}

TEST(Percentile, InterpolatesBetweenOrderStatistics) {
    EXPECT_DOUBLE_EQ(percentile({7}, 0.95), 7);
    EXPECT_DOUBLE_EQ(percentile({3, 1, 2}, 0), 1);
    EXPECT_DOUBLE_EQ(percentile({3, 1, 2}, 0.5), 2);
    EXPECT_DOUBLE_EQ(percentile({3, 1, 2}, 1), 3);
    EXPECT_DOUBLE_EQ(percentile({0, 10}, 0.95), 9.5);
    std::vector<float> values(101);
    std::iota(values.begin(), values.end(), 0.f);
    std::shuffle(values.begin(), values.end(), std::mt19937(1));
    EXPECT_DOUBLE_EQ(percentile(values, 0.95), 95);
}
