// Tests of temporal errors against a second computation: two passes over all frames in long double.
#include "sweep/temporal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace harness {
namespace {

Image randomImage(std::mt19937& random, float level) {
    Image image{7, 5, std::vector<float>(3 * 7 * 5)};
    for (float& value : image.rgb)
        value = std::generate_canonical<float, 24>(random) * level;
    return image;
}

long double shown(float linear) {
    const long double x = std::max(linear, 0.0f);
    return std::pow(x / (1 + x), 1 / 2.2L);
}

TEST(Temporal, AgreesWithASecondComputation) {
    std::mt19937 random(5);
    std::vector<Image> images, references;
    TemporalAccumulator accumulator;
    for (int t = 0; t < 6; ++t) {
        images.push_back(randomImage(random, 4));
        references.push_back(randomImage(random, t % 2 ? 0.01f : 100));
        accumulator.add(images.back(), references.back());
    }
    const size_t values = images[0].rgb.size(), shifts = images.size();
    long double bias = 0, variance = 0, image = 0, reference = 0, squared = 0;
    for (size_t i = 0; i < values; ++i) {
        long double meanError = 0, meanImage = 0, meanReference = 0;
        for (size_t t = 0; t < shifts; ++t) {
            meanImage += shown(images[t].rgb[i]) / shifts;
            meanReference += shown(references[t].rgb[i]) / shifts;
        }
        meanError = meanImage - meanReference;
        bias += meanError * meanError / values;
        for (size_t t = 0; t < shifts; ++t) {
            const long double a = shown(images[t].rgb[i]), r = shown(references[t].rgb[i]);
            variance += std::pow(a - r - meanError, 2) / shifts / values;
            image += std::pow(a - meanImage, 2);
            reference += std::pow(r - meanReference, 2);
            squared += std::pow(a - r, 2) / shifts / values;
        }
    }
    const TemporalError found = accumulator.result();
    EXPECT_NEAR(found.biasSquared, double(bias), 1e-9);
    EXPECT_NEAR(found.variance, double(variance), 1e-9);
    EXPECT_NEAR(found.flicker, double(std::sqrt(image / reference)), 1e-6);
    EXPECT_NEAR(found.biasSquared + found.variance, double(squared), 1e-9) << "the split is exact";
}

TEST(Temporal, StillAndEqualImages) {
    std::mt19937 random(6);
    const Image a = randomImage(random, 1), b = randomImage(random, 1);
    TemporalAccumulator equal, still, crawling;
    for (int t = 0; t < 4; ++t) {
        const Image moving = randomImage(random, 1);
        equal.add(moving, moving);
        still.add(a, b);
        crawling.add(moving, a);
    }
    EXPECT_EQ(equal.result().biasSquared, 0);
    EXPECT_EQ(equal.result().variance, 0);
    EXPECT_NEAR(equal.result().flicker, 1, 1e-12);
    EXPECT_GT(still.result().biasSquared, 0);
    EXPECT_NEAR(still.result().variance, 0, 1e-12);
    EXPECT_TRUE(std::isfinite(still.result().flicker));
    EXPECT_GT(crawling.result().flicker, 1e3) << "what stands still crawls here";
}

} // namespace
} // namespace harness
