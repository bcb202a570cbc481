// Filtered environments against sums over all directions.
#include "environment/environment.h"

#include <glm/gtc/packing.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace harness;

namespace {

constexpr double pi = std::numbers::pi;
constexpr uint32_t testWidth = 256; // of level 0; the coarsest one is then 4 x 2

Image constantImage(uint32_t width, const glm::vec3& radiance) {
    Image image{width, width / 2, {}};
    for (size_t i = 0; i < image.pixelCount(); ++i)
        for (int c = 0; c < 3; ++c)
            image.rgb.push_back(radiance[c]);
    return image;
}

// A dark sky with a bright spot of one pixel, which is not at a pole.
Image spotImage(uint32_t width, uint32_t x, uint32_t y) {
    Image image = constantImage(width, glm::vec3(0));
    for (size_t c = 0; c < 3; ++c)
        image.rgb[3 * (size_t(y) * width + x) + c] = 1000;
    return image;
}

// A smooth sky with a bright and a dark side, and a sun of a few pixels.
Image skyImage(uint32_t width) {
    Image image{width, width / 2, {}};
    std::mt19937 random(7);
    std::uniform_real_distribution<float> noise(0, 0.2f);
    for (uint32_t y = 0; y < width / 2; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::dvec3 d = sphereDirection(2 * pi * ((x + 0.5) / width - 0.5), pi * (y + 0.5) / (width / 2));
            const double sun = 40 * std::exp(400 * (glm::dot(d, glm::normalize(glm::dvec3(1, 1, -1))) - 1));
            image.rgb.push_back(float(0.5 + 0.4 * d.y + sun) + noise(random));
            image.rgb.push_back(float(0.5 + 0.3 * d.x + sun) + noise(random));
            image.rgb.push_back(float(0.6 + 0.4 * d.y + 0.8 * sun) + noise(random));
        }
    return image;
}

SphereImage sphereOf(const Image& image) {
    uint64_t replaced = 0;
    return makeSphereImage(image, testWidth, replaced);
}

glm::dvec3 meanOver(const SphereImage& image) {
    glm::dvec3 sum(0);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            sum += image.solidAngle(y) * glm::dvec3(image.at(x, y));
    return sum / (4 * pi);
}

// The mean of a level, whose texels stand for the directions that are nearest to theirs.
glm::dvec3 meanOver(const RadianceLevel& level) {
    glm::dvec3 sum(0);
    double weights = 0;
    for (uint32_t y = 0; y < level.height; ++y) {
        const double step = pi / (level.height - 1.0);
        const double from = std::max(0.0, (y - 0.5) * step), to = std::min(pi, (y + 0.5) * step);
        for (uint32_t x = 0; x < level.width; ++x) {
            const double weight = std::cos(from) - std::cos(to);
            sum += weight * glm::dvec3(level.texels[size_t(y) * level.width + x]);
            weights += weight;
        }
    }
    return sum / weights;
}

// The same convolution over all texels of the image: no samples, no smaller images.
glm::dvec3 bruteLobe(const SphereImage& image, const glm::dvec3& axis, double alpha) {
    const double a2 = alpha * alpha;
    glm::dvec3 sum(0);
    double weights = 0;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const double cosine = glm::dot(axis, glm::dvec3(image.directionOf(x, y)));
            const double d = (0.5 + 0.5 * cosine) * (a2 - 1) + 1;
            const double weight = cosine > 0 ? cosine * image.solidAngle(y) / (d * d) : 0;
            sum += weight * glm::dvec3(image.at(x, y));
            weights += weight;
        }
    return sum / weights;
}

glm::dvec3 bruteIrradiance(const SphereImage& image, const glm::dvec3& normal) {
    glm::dvec3 sum(0);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            sum += std::max(glm::dot(normal, glm::dvec3(image.directionOf(x, y))), 0.0) * image.solidAngle(y) *
                   glm::dvec3(image.at(x, y));
    return sum / pi;
}

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

std::vector<glm::dvec3> normals() {
    std::vector<glm::dvec3> list = {{0, 1, 0}, {0, -1, 0}};
    for (int i = 0; i < 20; ++i)
        list.push_back(sphereDirection(2.4 * i, std::acos(1 - (i + 0.5) / 10)));
    return list;
}

TEST(Prefilter, AConstantEnvironmentStaysConstant) {
    const glm::vec3 radiance(0.5f, 2, 0.125f);
    for (const uint32_t width : {2u, 6u, 64u, 300u}) { // 300 is reduced to 256
        const SphereImage sphere = sphereOf(constantImage(width, radiance));
        for (const glm::dvec3& normal : normals())
            EXPECT_LT(largest(glm::dvec3(irradianceAt(makeIrradiance(sphere), normal) - radiance)), 2e-3)
                << "width " << width;
        for (const RadianceLevel& level : makeRadianceLevels(sphere, testWidth))
            for (const glm::vec3& texel : level.texels)
                ASSERT_LT(largest(glm::dvec3(texel - radiance)), 1e-5) << "width " << width;
    }
}

TEST(Prefilter, ReducedImagesKeepTheEnergy) {
    uint64_t replaced = 0;
    const Image image = skyImage(300);
    SphereImage small = makeSphereImage(image, 128, replaced);
    EXPECT_EQ(small.width, 128u);
    SphereImage full{300, 150, {}};
    for (size_t i = 0; i < image.pixelCount(); ++i)
        full.texels.emplace_back(image.rgb[3 * i], image.rgb[3 * i + 1], image.rgb[3 * i + 2]);
    const glm::dvec3 mean = meanOver(full);
    EXPECT_LT(largest(meanOver(small) / mean - 1.0), 1e-5);
    EXPECT_LT(largest(meanOver(halved(small)) / mean - 1.0), 1e-5);
}

// Convolutions with a lobe that is the same for all axes keep the mean. The bounds are errors of the sums that stand
// for means: a spot of one pixel has the size of a texel of level 0, and levels below have few texels.
TEST(Prefilter, ABrightSpotKeepsItsEnergy) {
    for (const uint32_t y : {20u, 64u, 100u}) {
        const SphereImage sphere = sphereOf(spotImage(testWidth, 77, y));
        const glm::dvec3 mean = meanOver(sphere);
        const std::vector<RadianceLevel> levels = makeRadianceLevels(sphere, testWidth);
        for (size_t i = 0; i < 5; ++i) { // level 5 has 8 x 4 texels here, too few for a mean
            const double ratio = meanOver(levels[i]).x / mean.x;
            EXPECT_NEAR(ratio, 1, i == 0 ? 0.05 : 0.02) << "level " << i << ", row " << y;
        }
        const Irradiance irradiance = makeIrradiance(sphere);
        glm::dvec3 sum(0);
        for (uint32_t row = 0; row < sphere.height; ++row)
            for (uint32_t x = 0; x < sphere.width; ++x)
                sum += sphere.solidAngle(row) * glm::dvec3(irradianceAt(irradiance, sphere.directionOf(x, row)));
        // Nine coefficients are negative opposite a spot. What counts as 0 there adds 3 %.
        EXPECT_NEAR(sum.x / (4 * pi) / mean.x, 1.03, 0.005) << "row " << y;
    }
}

TEST(Prefilter, LevelsAreThoseOfAllDirections) {
    const SphereImage sphere = sphereOf(skyImage(testWidth));
    const std::vector<RadianceLevel> levels = makeRadianceLevels(sphere, testWidth);
    for (uint32_t i = 1; i < levels.size(); ++i) {
        const RadianceLevel& level = levels[i];
        double squares = 0, brightness = 0;
        for (uint32_t k = 0; k < 60; ++k) {
            const uint32_t x = k * 37 % level.width, y = k * 11 % level.height;
            const glm::dvec3 exact = bruteLobe(sphere, level.directionOf(x, y), alphaOfLevel(i));
            squares += std::pow(largest(glm::dvec3(level.texels[size_t(y) * level.width + x]) - exact), 2);
            brightness += exact.y;
        }
        EXPECT_LT(std::sqrt(squares / 60) / (brightness / 60), 0.03) << "level " << i;
    }
}

TEST(Prefilter, IrradianceIsThatOfAllDirections) {
    const SphereImage sphere = sphereOf(skyImage(128));
    const Irradiance irradiance = makeIrradiance(sphere);
    const double mean = meanOver(sphere).y;
    for (const glm::dvec3& normal : normals())
        EXPECT_LT(largest(glm::dvec3(irradianceAt(irradiance, normal)) - bruteIrradiance(sphere, normal)), 0.06 * mean);
}

// Row 0 of an image is up, its middle is -z, and +x is to the right.
TEST(Prefilter, DirectionsAreThoseOfTheImage) {
    const SphereImage sphere = sphereOf(spotImage(64, 48, 16)); // a quarter to the right, at the horizon
    const Irradiance irradiance = makeIrradiance(sphere);
    for (const glm::vec3 away : {glm::vec3(-1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)})
        EXPECT_GT(irradianceAt(irradiance, {1, 0, 0}).x, 2 * irradianceAt(irradiance, away).x);
    EXPECT_GT(sphere.lookup({1, 0, 0}).x, 100);
    EXPECT_EQ(sphere.lookup({-1, 0, 0}).x, 0);
    const SphereImage up = sphereOf(spotImage(64, 3, 0));
    EXPECT_GT(irradianceAt(makeIrradiance(up), {0, 1, 0}).x, irradianceAt(makeIrradiance(up), {1, 0, 0}).x);
}

TEST(Prefilter, ValuesThatAreNotFiniteAreContained) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    Image image = constantImage(64, glm::vec3(1));
    image.rgb[0] = std::numeric_limits<float>::quiet_NaN();
    image.rgb[1] = infinity;
    image.rgb[2] = -infinity;
    image.rgb[3000] = -5;
    image.rgb[4000] = std::numeric_limits<float>::max();
    const Environment environment = makeEnvironment(image);
    EXPECT_EQ(environment.replacedValues, 5u);
    for (const glm::vec4& coefficient : environment.constants.irradiance)
        EXPECT_TRUE(std::isfinite(coefficient.x) && std::isfinite(coefficient.y) && std::isfinite(coefficient.z));
    float brightest = 0;
    for (const HalfLevel& level : environment.levels)
        for (const uint16_t half : level.rgba) {
            const float value = glm::unpackHalf1x16(half);
            ASSERT_TRUE(std::isfinite(value) && value >= 0);
            brightest = std::max(brightest, value);
        }
    EXPECT_EQ(brightest, 65504);
}

TEST(Prefilter, ResultsAreRepeatable) {
    const Environment a = makeEnvironment(skyImage(64)), b = makeEnvironment(skyImage(64));
    ASSERT_EQ(a.levels.size(), radianceLevelCount);
    EXPECT_EQ(a.levels.front().width, radianceWidth);
    for (size_t i = 0; i < a.levels.size(); ++i)
        EXPECT_EQ(a.levels[i].rgba, b.levels[i].rgba);
}

} // namespace
