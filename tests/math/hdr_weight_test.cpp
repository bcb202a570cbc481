// The weights of events of a high range of light (src/shaders/math/hdr_weight.glsl).
#include "test_support.h"

using namespace test_math;

namespace {

struct Light {
    double r, g, b;
    double luminance() const { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }
};

// sum(w c) / sum(w), without the difference by which the shader finds the sum of weights.
Light meanOf(const std::vector<Light>& events, double exposure) {
    Light sum{};
    double weights = 0;
    for (const Light& c : events) {
        const double w = 1 / (1 + exposure * c.luminance());
        sum = {sum.r + w * c.r, sum.g + w * c.g, sum.b + w * c.b};
        weights += w;
    }
    return {sum.r / weights, sum.g / weights, sum.b / weights};
}

math_f::rvec3 resolved(const std::vector<Light>& events, double exposure) {
    math_f::rvec3 sum(0.0f);
    for (const Light& c : events)
        sum += math_f::agaa_weightByLuminance(math_f::rvec3(float(c.r), float(c.g), float(c.b)), float(exposure));
    return math_f::agaa_lightOfWeightedMean(sum / float(events.size()), float(exposure));
}

std::vector<Light> randomEvents(Random& random, double brightest) {
    std::vector<Light> events(size_t(random.range(1, 33)));
    for (Light& c : events) {
        const double luminance = random.decades(1e-6, brightest);
        c = {luminance * random.range(0, 1), luminance * random.range(0, 1), luminance * random.range(0, 1)};
    }
    return events;
}

TEST(HdrWeight, MeansAgreeWithDouble) {
    Random random(21);
    Worst ordinary("mean of light up to 100 times white, relative", 1.3e-5);
    Worst bright("mean of light up to 65504 times white, relative", 8e-3);
    for (int i = 0; i < 100000; ++i) {
        const double exposure = random.decades(1e-6, 1e3);
        const std::vector<Light> dim = randomEvents(random, 100 / exposure);
        ordinary.relative(double(resolved(dim, exposure).x), meanOf(dim, exposure).r);
        const std::vector<Light> all = randomEvents(random, 65504 / exposure);
        bright.relative(double(resolved(all, exposure).y), meanOf(all, exposure).g);
    }
}

// Equal events add their rounding in one direction, and the difference that finds the sum of weights magnifies it.
TEST(HdrWeight, EqualEventsReturn) {
    Random random(23);
    Worst ordinary("equal events up to 100 times white, relative", 1.2e-4);
    Worst bright("equal events up to 65504 times white, relative", 8e-2);
    for (int i = 0; i < 50000; ++i) {
        const double exposure = random.decades(1e-6, 1e3);
        for (const size_t count : {size_t(1), size_t(8), size_t(32), size_t(64)}) {
            const double dim = random.decades(1e-6, 100) / exposure, any = random.decades(1, 65504) / exposure;
            ordinary.relative(double(resolved(std::vector<Light>(count, {dim, dim, dim}), exposure).x), dim);
            bright.relative(double(resolved(std::vector<Light>(count, {any, any, any}), exposure).x), any);
        }
    }
}

TEST(HdrWeight, WithoutExposureTheMeanIsLinear) {
    Random random(22);
    Worst worst("linear mean, relative", 6e-7);
    for (int i = 0; i < 10000; ++i) {
        const std::vector<Light> events = randomEvents(random, 65504);
        worst.relative(double(resolved(events, 0).z), meanOf(events, 0).b);
    }
}

TEST(HdrWeight, ExtremeInputStaysFinite) {
    for (float r : extremeFloats())
        for (float g : extremeFloats())
            for (float exposure : {0.0f, 1e-38f, 1e-6f, 1.0f, 1e9f}) {
                const math_f::rvec3 light(std::clamp(r, -65504.0f, 65504.0f), std::clamp(g, -65504.0f, 65504.0f), 1.0f);
                if (std::isnan(r) || std::isnan(g))
                    continue; // the caller replaces it
                const math_f::rvec3 mean =
                    math_f::agaa_lightOfWeightedMean(math_f::agaa_weightByLuminance(light, exposure), exposure);
                EXPECT_TRUE(std::isfinite(mean.x) && std::isfinite(mean.y) && std::isfinite(mean.z))
                    << r << ' ' << g << ' ' << exposure;
            }
}

} // namespace
