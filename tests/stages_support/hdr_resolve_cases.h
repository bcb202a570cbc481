// Pixels of very bright and dark events, resolved with weights (AGAA_CONFIG_HDR_RESOLVE), in every technique and tier.
// Each graphics API instantiates these.
#pragma once

#include "hard_case_test.h"
#include "technique_tiers.h"
#include "view_bench.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <span>

namespace agaa::test {

template <class Host> class HdrResolveCases : public HardCaseTest<Host> {
protected:
    // A bright panel before a dark ground, which ends in the middle, over the background. Each pixel has two colours at
    // most, because the ground's edges lie between pixels.
    // exposures: a frame of one view for each; none: a frame without weights.
    std::vector<std::vector<float>> render(const TechniqueTier& tier, std::span<const float> exposures) {
        ViewSettings settings = pixelView({tier.technique, tier.n});
        apply(tier, settings);
        settings.facts.flags = AGAA_FACT_AMBIENT;
        settings.facts.shadowMapCount = 0;
        settings.config.flags |= exposures.empty() ? 0 : AGAA_CONFIG_HDR_RESOLVE;
        Material dark = facing({0.1f, 0.1f, 0.1f});
        dark.normal = {0.6f, 0, 0.8f, 1}; // so that samples of both are no aggregate
        std::vector<Triangle> triangles = rectangle(0, 0, 16, 16, 8, dark);
        for (const Triangle& t : rectangle(4.3f, 3.4f, 27.6f, 12.7f, 3, facing({1, 1, 1})))
            triangles.push_back(t);
        float exposure = 1;
        const auto light = [&](AgaaFrame& frame) {
            std::ranges::fill(frame.ambient, panel);
            std::fill_n(frame.background, 3, background);
            frame.exposure = exposure;
        };
        ViewBench<Host> bench(this->context, settings, {.triangles = triangles, .lights = {}, .change = light});
        bench.setTriangles(triangles);
        std::vector<std::vector<float>> images;
        for (const float each : exposures) {
            exposure = each;
            images.push_back(bench.rgb());
        }
        if (exposures.empty())
            images.push_back(bench.rgb());
        return images;
    }
    static constexpr float panel = 200, background = 0.05f;
};
TYPED_TEST_SUITE_P(HdrResolveCases);

constexpr double displayedLight(double exposed) { return exposed / (1 + exposed); }

TYPED_TEST_P(HdrResolveCases, EventsHaveTheirWeights) {
    for (size_t setting = 0; const TechniqueTier& tier : techniqueTiers()) {
        SCOPED_TRACE(testing::Message() << tier);
        if (!rendersSetting<TypeParam>(setting++) || tier.isBatched || !runs(tier, this->context.get()->caps))
            continue;
        if (tier.isMixed)
            continue; // the host's unfetched triangles have other materials
        const std::vector<float> linear = this->render(tier, {})[0];
        const float ground = linear[0];
        EXPECT_NEAR(ground, 0.1f * this->panel, 0.5f);
        const std::array exposures{0.0f, 0.02f, 1.0f};
        const std::vector<std::vector<float>> images = this->render(tier, exposures);
        for (size_t frame = 0; frame < exposures.size(); ++frame) {
            const float exposure = exposures[frame];
            const std::vector<float>& resolved = images[frame];
            if (tier.n == 1) {
                EXPECT_EQ(resolved, linear);
                continue;
            }
            double worst = 0;
            std::ostringstream where;
            uint32_t mixed = 0;
            for (size_t i = 0; i < linear.size(); i += 3) {
                const double behind = i / 3 % 32 < 16 ? double(ground) : double(this->background);
                const double share = (double(linear[i]) - behind) / (double(this->panel) - behind);
                const double front = share / (1 + double(exposure) * double(this->panel));
                const double back = (1 - share) / (1 + double(exposure) * behind);
                const double expected = (front * double(this->panel) + back * behind) / (front + back);
                mixed += share > 0.05 && share < 0.95;
                const double error = exposure > 0 ? std::abs(displayedLight(double(exposure * resolved[i])) -
                                                             displayedLight(double(exposure) * expected))
                                                  : std::abs(double(resolved[i]) / expected - 1);
                if (error > worst) {
                    worst = error;
                    where << "pixel " << i / 3 % 32 << ", " << i / 3 / 32 << ": " << resolved[i] << " for " << expected
                          << " of share " << share << "; ";
                }
            }
            EXPECT_GE(mixed, 40u);
            EXPECT_LT(worst, 1e-5) << "exposure " << exposure << ": " << where.str();
        }
    }
}

// Light far beyond white, light that is not finite, and none.
TYPED_TEST_P(HdrResolveCases, ExtremeLightIsContained) {
    for (const TechniqueTier& tier : {TechniqueTier{.technique = "ssaa", .n = 8},
                                      {.technique = "msaa", .n = 4},
                                      {.technique = "agaa", .n = 8, .tier = AGAA_TIER_GBUFFER},
                                      {.technique = "dcaa", .n = 64, .tier = AGAA_TIER_MATERIAL_LISTS}}) {
        SCOPED_TRACE(testing::Message() << tier);
        for (const float exposure : {1e-30f, 1.0f, 1e9f}) {
            ViewSettings settings = pixelView({tier.technique, tier.n});
            apply(tier, settings);
            settings.facts.flags = AGAA_FACT_AMBIENT;
            settings.facts.shadowMapCount = 0;
            settings.config.flags |= AGAA_CONFIG_HDR_RESOLVE;
            const auto light = [&](AgaaFrame& frame) {
                std::ranges::fill(frame.ambient, 65504.0f);
                frame.exposure = exposure;
            };
            AgaaLight sun = test::sun();
            std::ranges::fill(sun.color, 1e30f);
            const std::vector<float> rgb = show(this->context, settings,
                                                {.triangles = rectangle(4.3f, 3.4f, 27.6f, 12.7f, 3, facing({1, 1, 1})),
                                                 .lights = {sun},
                                                 .change = light})
                                               .rgb;
            for (const float value : rgb) {
                ASSERT_TRUE(std::isfinite(value));
                ASSERT_GE(value, 0.0f);
                ASSERT_LE(value, 65504.0f);
            }
            // A pixel of light alone keeps it, up to 65536 times white.
            const double whole = std::min(65504.0, 65536.0 / double(exposure));
            EXPECT_NEAR(double(rgb[3 * (8 * 32 + 16)]) / whole, 1, 0.02) << "exposure " << exposure;
        }
    }
}

// After tone mapping, a slanted edge has as many pixels between its colours at any contrast. In a linear mean they get
// fewer with the contrast.
TYPED_TEST_P(HdrResolveCases, EdgesOfAnyContrastKeepTheirMidTones) {
    std::map<float, size_t> linear, weighted;
    for (const float contrast : {1.0f, 10.0f, 100.0f, 1000.0f})
        for (const bool isWeighted : {false, true}) {
            ViewSettings settings = pixelView({"ssaa", 32});
            settings.facts.flags = AGAA_FACT_AMBIENT;
            settings.facts.shadowMapCount = 0;
            settings.config.flags |= isWeighted ? AGAA_CONFIG_HDR_RESOLVE : 0;
            const auto light = [&](AgaaFrame& frame) {
                std::ranges::fill(frame.ambient, contrast);
                std::fill_n(frame.background, 3, 0.0f);
            };
            Triangle half;
            half.position[0] = {-100, -90, -5};
            half.position[1] = {100, -90, -5};
            half.position[2] = {100, 95, -5};
            half.material = facing({1, 1, 1});
            const std::vector<float> rgb =
                show(this->context, settings, {.triangles = {half}, .lights = {}, .change = light}).rgb;
            const double bright = displayedLight(double(contrast));
            size_t& count = (isWeighted ? weighted : linear)[contrast];
            for (size_t i = 0; i < rgb.size(); i += 3) {
                const double share = displayedLight(double(rgb[i])) / bright;
                count += share > 0.1 && share < 0.9;
            }
        }
    for (const auto& [contrast, count] : weighted)
        EXPECT_EQ(count, weighted.begin()->second) << "contrast " << contrast;
    EXPECT_GE(weighted.begin()->second, 15u);
    EXPECT_LT(linear[10], linear[1]) << "of a linear mean";
    EXPECT_LT(4 * linear[100], linear[1]) << "of a linear mean";
    std::printf("mid-tone pixels at contrast 1, 10, 100 and 1000: linear %zu, %zu, %zu, %zu; weighted %zu\n", linear[1],
                linear[10], linear[100], linear[1000], weighted.begin()->second);
}

REGISTER_TYPED_TEST_SUITE_P(HdrResolveCases, EventsHaveTheirWeights, ExtremeLightIsContained,
                            EdgesOfAnyContrastKeepTheirMidTones);

} // namespace agaa::test
