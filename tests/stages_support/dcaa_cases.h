// Decoupled coverage, by what can be seen from outside. Each graphics API instantiates these.
#pragma once

#include "shown.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace agaa::test {

inline ViewSettings dcaaSettings(uint32_t samples = 64, uint32_t surfaces = 4) {
    ViewSettings settings;
    settings.config.technique = "dcaa";
    settings.config.samples = samples;
    settings.config.aggregates = surfaces;
    settings.config.generationTier = AGAA_TIER_FRAGMENT_LISTS;
    settings.facts.shadowMapCount = 0;
    return settings;
}

template <class Host>
class DcaaCases : public testing::Test {
protected:
    Shown render(const ViewSettings& settings, const Shot& shot) { return show(context, settings, shot); }

    typename Host::Context context;
};
TYPED_TEST_SUITE_P(DcaaCases);

// A rectangle of radiance 1 before black: pixels show the share that it covers.
TYPED_TEST_P(DcaaCases, EdgesCoverTheirShare) {
    for (const uint32_t samples : {32u, 64u, 128u}) {
        SCOPED_TRACE(samples);
        ViewSettings settings = dcaaSettings(samples);
        settings.projection = pixelOrthographic(48, 32, 10);
        Material material;
        material.diffuse = material.specular = glm::vec4(0);
        material.emissive = glm::vec4(1);
        const float x0 = 3.3f, x1 = 20.7f, y0 = 5.45f, y1 = 17.15f;
        const Shown shown = this->render(settings, {.triangles = rectangle(x0, y0, x1, y1, 5, material)});
        for (uint32_t y = 0; y < 32; ++y)
            for (uint32_t x = 0; x < 48; ++x) {
                const auto share = [](float low, float high, uint32_t at) {
                    return std::clamp(std::min(high, float(at + 1)) - std::max(low, float(at)), 0.0f, 1.0f);
                };
                const float expected = share(x0, x1, x) * share(y0, y1, y);
                EXPECT_NEAR(shown.rgb[3 * (48 * y + x)], expected, 0.06f) << x << ", " << y;
            }
        EXPECT_NEAR(sumOf(shown.rgb) / 3, double((x1 - x0) * (y1 - y0)), 1.0);
        EXPECT_EQ(shown.geometryPasses, 1u);
        EXPECT_TRUE(shown.validation.isValid) << shown.validation.explanation;
    }
}

TYPED_TEST_P(DcaaCases, ShowsWhatManySamplesShow) {
    const Shot shot{.triangles = randomTriangles({.triangles = 150}, 61), .change = addAmbient};
    ViewSettings settings;
    settings.config.technique = "ssaa";
    settings.config.samples = 32;
    settings.facts.shadowMapCount = 0;
    const Shown truth = this->render(settings, shot);
    settings.config.samples = 8;
    const double eight = compare(this->render(settings, shot).rgb, truth.rgb).psnr;
    for (const uint32_t surfaces : {1u, 2u, 4u, 8u}) {
        const Shown shown = this->render(dcaaSettings(64, surfaces), shot);
        const Difference d = compare(shown.rgb, truth.rgb);
        std::printf("%u surfaces: PSNR %.1f dB (ssaa 8: %.1f), fragments %llu, merged %llu + %llu, discarded %llu\n", surfaces,
                    d.psnr, eight, (unsigned long long)shown.counters.fragments, (unsigned long long)shown.counters.mergedFirst,
                    (unsigned long long)shown.counters.mergedSecond, (unsigned long long)shown.counters.discarded);
        EXPECT_EQ(nonFinite(shown.rgb), 0u);
    }
}

REGISTER_TYPED_TEST_SUITE_P(DcaaCases, EdgesCoverTheirShare, ShowsWhatManySamplesShow);

} // namespace agaa::test
