// Alpha-masked surfaces through the whole pipeline: which part of a pixel they cover, by every technique, tier and
// number of samples. Each graphics API instantiates these.
#pragma once

#include "setting_share.h"
#include "shown.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

namespace agaa::test {

struct CoverageSetting {
    const char* technique;
    uint32_t n;
    uint32_t tier = AGAA_TIER_AUTO;
    uint64_t flags = 0; // of AgaaConfig
};
constexpr CoverageSetting coverageSettings[] = {{"single", 1},
                                                {"msaa", 4},
                                                {"msaa", 8},
                                                {"msaa", 32},
                                                {"ssaa", 1},
                                                {"ssaa", 2},
                                                {"ssaa", 4},
                                                {"ssaa", 8},
                                                {"ssaa", 16},
                                                {"ssaa", 32},
                                                {"ssaa", 9},
                                                {"msaa", 9},
                                                {"adaptive", 8},
                                                {"adaptive", 9},
                                                {"adaptive", 32},
                                                {"visibility", 8},
                                                {"simple_complex", 4},
                                                {"simple_complex", 8},
                                                {"simple_complex", 32},
                                                {"sbaa", 2},
                                                {"sbaa", 8},
                                                {"sbaa", 16},
                                                {"agaa", 1},
                                                {"agaa", 2},
                                                {"agaa", 4},
                                                {"agaa", 8},
                                                {"agaa", 8, AGAA_TIER_PER_SAMPLE},
                                                {"agaa", 16},
                                                {"agaa", 16, AGAA_TIER_PER_SAMPLE},
                                                {"agaa", 32},
                                                {"agaa", 2, AGAA_TIER_GBUFFER},
                                                {"agaa", 8, AGAA_TIER_GBUFFER},
                                                {"agaa", 8, AGAA_TIER_GBUFFER, AGAA_CONFIG_BUFFERED},
                                                {"agaa", 32, AGAA_TIER_GBUFFER},
                                                {"agaa", 2, AGAA_TIER_IDS},
                                                {"agaa", 8, AGAA_TIER_IDS},
                                                {"agaa", 8, AGAA_TIER_IDS, AGAA_CONFIG_BUFFERED},
                                                {"agaa", 32, AGAA_TIER_IDS}};
inline std::ostream& operator<<(std::ostream& out, const CoverageSetting& s) {
    return out << s.technique << " n=" << s.n << ' ' << agaaTierName(s.tier) << (s.flags ? " buffered" : "");
}

// The mean of f over a pixel.
inline double overPixel(int x, int y, const std::function<double(double, double)>& f) {
    constexpr int side = 64;
    double sum = 0;
    for (int i = 0; i < side * side; ++i)
        sum += f(x + (i % side + 0.5) / side, y + (i / side + 0.5) / side);
    return sum / (side * side);
}

template <class Host> class CoverageCases : public testing::Test {
protected:
    static constexpr uint32_t width = 96, height = 64;

    // The coverage of each pixel by white cards over black that fill the view, one behind the other.
    std::vector<double> cover(const CoverageSetting& s, const char* surface, int layers = 1, uint32_t ditherFrame = 0) {
        ViewSettings settings;
        settings.width = width;
        settings.height = height;
        settings.projection = pixelOrthographic(width, height, 10);
        settings.config.technique = s.technique;
        settings.config.samples = s.n;
        settings.config.generationTier = s.tier;
        settings.config.flags |= s.flags;
        settings.facts.shadowMapCount = 0;
        settings.surface = surface;
        Material material;
        material.diffuse = glm::vec4(1);
        material.specular = glm::vec4(0);
        material.normal = glm::vec4(0, 0, 1, 1);
        std::vector<Triangle> triangles;
        for (int layer = 0; layer < layers; ++layer)
            for (Triangle t : rectangle(0, 0, float(width), float(height), float(4 + layer), material)) {
                t.isMasked = true;
                triangles.push_back(t);
            }
        const Shown shown = show(context_, settings, {.triangles = triangles, .change = [&](AgaaFrame& frame) {
                                                          frame.background[0] = frame.background[1] =
                                                              frame.background[2] = 0;
                                                          frame.ditherFrame = ditherFrame;
                                                      }});
        EXPECT_EQ(nonFinite(shown.rgb), 0u) << s;
        EXPECT_EQ(shown.counters.uncovered, 0u) << s;
        EXPECT_EQ(shown.counters.overlapping, 0u) << s;
        std::vector<double> out;
        for (size_t i = 0; i < shown.rgb.size(); i += 3)
            out.push_back(double(shown.rgb[i]) * 3.14159265 / 3); // by the sun, of irradiance 3
        return out;
    }
    static double mean(const std::vector<double>& values) {
        double sum = 0;
        for (double v : values)
            sum += v;
        return sum / double(values.size());
    }
    // Of exact coverage: alpha(x, y) reaches one half.
    static double meanError(const std::vector<double>& coverage, const std::function<double(double, double)>& alpha) {
        double sum = 0;
        for (uint32_t y = 0; y < height; ++y)
            for (uint32_t x = 0; x < width; ++x)
                sum += std::abs(coverage[y * width + x] - overPixel(int(x), int(y), [&](double u, double v) {
                                    return alpha(u, v) >= 0.5 ? 1.0 : 0.0;
                                }));
        return sum / double(width * height);
    }

    // Returns whether this graphics API renders a setting of coverageSettings.
    static bool renders(const CoverageSetting& s) { return rendersSetting<Host>(size_t(&s - coverageSettings)); }

private:
    typename Host::Context context_;
};
TYPED_TEST_SUITE_P(CoverageCases);

// Every technique of the same n covers the same samples, and these follow the edge.
TYPED_TEST_P(CoverageCases, CutoutsAreTestedAtEachSample) {
    const auto alpha = [](double x, double y) { return 25.9 - std::hypot(x - 48.3, y - 31.9); };
    std::map<uint32_t, std::vector<double>> known;
    std::map<uint32_t, double> errors;
    for (const CoverageSetting& s : coverageSettings) {
        if (known.contains(s.n) && !this->renders(s))
            continue;
        const std::vector<double> coverage = this->cover(
            s, "precise vec3 at = AGAA_AT_CENTRE(position); precise float a = 25.9 - length(at.xy - vec2(48.3, 31.9)); "
               "s.alpha = a; s.alphaCutoff = 0.5;");
        const auto [first, isNew] = known.try_emplace(s.n, coverage);
        if (isNew)
            errors[s.n] = this->meanError(coverage, alpha);
        for (size_t i = 0; i < coverage.size(); ++i)
            ASSERT_NEAR(coverage[i], first->second[i], 2e-3)
                << s << " pixel " << i % this->width << ' ' << i / this->width;
    }
    for (const auto& [n, error] : errors)
        std::printf("[ measured ] n=%-2u mean error of coverage %.5f\n", n, error);
    for (size_t i = 0; i < known[1].size(); ++i) // at n = 1 a hard test at the pixel's centre
        ASSERT_NEAR(known[1][i], alpha(double(i % this->width) + 0.5, double(i / this->width) + 0.5) >= 0.5, 1e-3) << i;
    EXPECT_LT(errors[4], 0.4 * errors[1]);
    EXPECT_LT(errors[8], 0.3 * errors[1]);
    EXPECT_LT(errors[32], 0.15 * errors[1]);
}

// Stems of 0.7 pixels that lean: no plane has two edges.
TYPED_TEST_P(CoverageCases, FourPointsFollowThinStems) {
    const auto alpha = [](double x, double y) {
        const double u = (x + 0.2 * y) / 5;
        return 0.5 + 0.35 - 5 * std::abs(u - std::floor(u) - 0.5);
    };
    const std::string one = "precise vec3 at = AGAA_AT_CENTRE(position); "
                            "precise float a = 0.85 - 5.0 * abs(fract((at.x + 0.2 * at.y) / 5.0) - 0.5); "
                            "s.alpha = a; s.alphaCutoff = 0.5;";
    const std::string four =
        one + " s.hasAlphaNear = true; for (uint k = 0u; k < AGAA_ALPHA_POINTS; ++k) { precise vec2 p = at.xy + "
              "agaa_alphaPoint(k); precise float b = 0.85 - 5.0 * abs(fract((p.x + 0.2 * p.y) / 5.0) - 0.5); "
              "s.alphaNear[k] = b; }";
    for (const CoverageSetting& s : coverageSettings) {
        if (s.n == 9) // one sample per texel, of which alpha is known exactly
            continue;
        if (s.n < 8 || (s.technique != std::string("ssaa") && s.technique != std::string("msaa")))
            continue;
        const double plane = this->meanError(this->cover(s, one.c_str()), alpha);
        const double bilinear = this->meanError(this->cover(s, four.c_str()), alpha);
        std::printf("[ measured ] %s n=%u mean error of coverage: one point %.4f, four %.4f\n", s.technique, s.n, plane,
                    bilinear);
        EXPECT_LT(bilinear, 0.8 * plane) << s;
    }
}

TYPED_TEST_P(CoverageCases, TwoTranslucentLayersCoverThreeQuarters) {
    for (const CoverageSetting& s : coverageSettings) {
        if (!this->renders(s))
            continue;
        const char* half = "s.alpha = 0.5;";
        if (s.technique == std::string("ssaa")) {
            EXPECT_NEAR(this->mean(this->cover(s, half, 1)), 0.5, 0.02) << s;
        }
        EXPECT_NEAR(this->mean(this->cover(s, half, 2)), 0.75, 0.02) << s;
    }
}

// The same number gives the same bits; over frames of other numbers each pixel converges.
TYPED_TEST_P(CoverageCases, DitherFramesSelectTheSamplesOfTranslucentSurfaces) {
    const CoverageSetting s{"agaa", 4};
    const char* third = "s.alpha = 0.3;";
    const std::vector<double> still = this->cover(s, third);
    EXPECT_EQ(still, this->cover(s, third));
    std::vector<double> sum(still.size());
    constexpr uint32_t frames = 24;
    for (uint32_t frame = 1; frame <= frames; ++frame) {
        const std::vector<double> one = this->cover(s, third, 1, frame);
        EXPECT_NE(one, still);
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += one[i] / frames;
    }
    double spread = 0, stillSpread = 0;
    for (size_t i = 0; i < sum.size(); ++i) {
        spread += (sum[i] - 0.3) * (sum[i] - 0.3);
        stillSpread += (still[i] - 0.3) * (still[i] - 0.3);
    }
    std::printf("[ measured ] mean squared error of a pixel's coverage: one frame %.4f, 24 frames %.5f\n",
                stillSpread / double(sum.size()), spread / double(sum.size()));
    EXPECT_LT(spread, stillSpread / 16);
}

// One pixel whose alpha is no number counts as 0 there, and changes its neighbours' edge by no more than such a pixel.
TYPED_TEST_P(CoverageCases, AlphaThatIsNoNumberInAPixelIsZeroThere) {
    const std::string whole = "precise vec3 at = AGAA_AT_CENTRE(position); float zero = s.alpha2 - s.alpha2; "
                              "bool isBad = int(at.x) % 7 == 3 && int(at.y) % 5 == 2; "
                              "precise float a = isBad ? ";
    for (const CoverageSetting& s : coverageSettings) {
        if (s.n == 8 && this->renders(s)) {
            EXPECT_EQ(this->cover(s, (whole + "0.0 / zero : 1.0; s.alpha = a; s.alphaCutoff = 0.5;").c_str()),
                      this->cover(s, (whole + "0.0 : 1.0; s.alpha = a; s.alphaCutoff = 0.5;").c_str()))
                << s;
        }
    }
}

// Fragments without a sample are in no aggregate, list or surface.
TYPED_TEST_P(CoverageCases, HardCase28AlphaThatIsNoNumberCoversNothing) {
    for (const CoverageSetting& s : coverageSettings) {
        if (s.n != 8 || !this->renders(s))
            continue;
        for (const char* cutoff : {"", " s.alphaCutoff = 0.5;"})
            for (const char* bad : {"s.alpha = 0.0 / (s.alpha2 - s.alpha2);", "s.alpha = 1.0 / (s.alpha2 - s.alpha2);"})
                EXPECT_EQ(this->mean(this->cover(s, (std::string(bad) + cutoff).c_str())), 0) << s << bad << cutoff;
    }
}

REGISTER_TYPED_TEST_SUITE_P(CoverageCases, CutoutsAreTestedAtEachSample, FourPointsFollowThinStems,
                            TwoTranslucentLayersCoverThreeQuarters, DitherFramesSelectTheSamplesOfTranslucentSurfaces,
                            AlphaThatIsNoNumberInAPixelIsZeroThere, HardCase28AlphaThatIsNoNumberCoversNothing);

} // namespace agaa::test
