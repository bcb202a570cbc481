#include "hard/checks.h"

#include "image/tonemap.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>

namespace harness::hard {

namespace {

double largestDifference(const Image& a, const Image& b) {
    double largest = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i) {
        const double difference = std::fabs(toneMap(double(a.rgb[i])) - toneMap(double(b.rgb[i])));
        if (!(difference <= largest))
            largest = difference; // NaN, too
    }
    return largest;
}

} // namespace

Finding differenceFromOther(const Rendered& frame, double bound) {
    return {largestDifference(frame.result.image, *frame.other), bound};
}

Finding bitsOfOther(const Rendered& frame) {
    double differing = 0;
    for (size_t i = 0; i < frame.other->rgb.size(); ++i)
        differing += std::memcmp(&frame.other->rgb[i], &frame.result.image.rgb[i], sizeof(float)) != 0;
    return {differing, 0};
}

// Returns whether the technique blends pixels of an image of half floats.
static bool filtersImage(const Rendered& frame) {
    const std::string_view technique = frame.configuration.technique;
    return technique == "fxaa" || technique == "smaa" || technique == "taa";
}

Finding bitsOfBackground(const Rendered& frame) {
    double differing = 0;
    const bool isHalf = filtersImage(frame);
    for (size_t i = 0; i < frame.result.image.rgb.size(); ++i) {
        const float expected = frame.settings.background[int(i % 3)], value = frame.result.image.rgb[i];
        const bool isEqual = isHalf ? std::fabs(value - expected) <= std::ldexp(expected, -10)
                                    : std::memcmp(&expected, &value, sizeof(float)) == 0;
        differing += !isEqual;
    }
    return {differing, 0};
}

Finding wholeWeights(const Rendered& frame) {
    const double n = frame.configuration.samples;
    double farthest = 0;
    if (filtersImage(frame))
        return {0, 0.002};
    for (const float value : frame.result.image.rgb) {
        const double weight = n * double(value);
        const double distance = std::fabs(weight - std::round(weight));
        if (!(distance <= farthest))
            farthest = distance;
    }
    return {farthest, 0.002};
}

Finding rampError(const Rendered& frame) {
    const Image& image = frame.result.image;
    // Sums of n samples have 16 bits, so that a code of a sample has fewer.
    const double codes = std::exp2(16 - std::log2(double(frame.configuration.samples))) - 1;
    double worst = 0;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const double expected = double(x / 4 + 1) / 16 / 255;
            for (size_t c = 0; c < 3; ++c) {
                const double value = double(image.rgb[(size_t(y) * image.width + x) * 3 + c]);
                const double error =
                    value > 0 ? std::fabs(value - expected) * codes : std::numeric_limits<double>::infinity();
                if (!(error <= worst))
                    worst = error;
            }
        }
    return {worst, 0.52};
}

Finding largestJump(const Rendered& frame, double bound) {
    constexpr int steps = 16;
    RenderSettings settings = frame.settings;
    Image before = frame.result.image;
    double largest = 0;
    for (int step = 1; step <= steps; ++step) {
        settings.jitter = {double(step) / steps, 0};
        const Image image = frame.renderer.render(settings).image;
        ++*frame.frames;
        for (const float value : image.rgb)
            *frame.nonFinite += !std::isfinite(value);
        largest = std::max(largest, largestDifference(before, image));
        before = image;
    }
    return {largest, bound};
}

} // namespace harness::hard
