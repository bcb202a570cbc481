// Error of aggregated shading against shading every one of the same samples.
#include "support.h"

#include "image/metrics.h"
#include "scene/gltf.h"
#include "sweep/reference.h"

#include <gtest/gtest.h>

namespace harness::test {
namespace {

class Accuracy : public testing::TestWithParam<TestScene> {
protected:
    // mseTm of single and of agaa with 1, 2 and 4 aggregates, against ssaa of the same samples.
    struct Errors {
        double single, one, two, four;
    };
    Errors measure(RenderSettings s) const {
        const auto render = [&](const char* technique, uint32_t aggregates) {
            s.config.technique = technique;
            s.config.aggregates = aggregates;
            return sharedRenderer().render(s).image;
        };
        const Image reference = render("ssaa", 1);
        const auto error = [&](const char* technique, uint32_t aggregates) {
            return compareImages(reference, render(technique, aggregates)).mseTm;
        };
        return {error("single", 1), error("agaa", 1), error("agaa", 2), error("agaa", 4)};
    }
    void print(const char* what, const Errors& e) const {
        std::printf("%-24s %-11s mseTm single %.3g; of it c=1 %.4f, c=2 %.4f, c=4 %.4f\n",
                    GetParam().name.c_str(), what, e.single, e.one / e.single, e.two / e.single,
                    e.four / e.single);
    }
};

TEST_P(Accuracy, MoreAggregatesErrLessAndTwoErrATenthOfSingle) {
    const Scene scene = loadScene(GetParam().source);
    sharedRenderer().load(scene);
    RenderSettings s = settingsFor(GetParam(), scene, 320, 180);
    const Errors e = measure(s);
    print("all effects", e);
    EXPECT_LE(e.two, e.one);
    EXPECT_LE(e.four, e.two);
    if (GetParam().name == "metal") {
        // Polished tubes spread their normals in one direction; the isotropic lobe spreads them in
        // all (AGAA section 5.1.2 shows this scene with LEAN). Without the specular term the bound
        // holds, so the lobe is the cause and nothing else.
        EXPECT_LE(e.two, 0.7 * e.single);
        s.facts.flags &= ~AGAA_FACT_SPECULAR;
        const Errors diffuse = measure(s);
        print("no specular", diffuse);
        EXPECT_LE(diffuse.two, 0.1 * diffuse.single);
    } else {
        EXPECT_LE(e.two, 0.1 * e.single);
    }
    EXPECT_TRUE(sharedRenderer().takeMessages().empty());
}

// The presets from a G-buffer, where materials are those of ssaa: each errs less than the one before, and
// `paper` more than the last two.
TEST_P(Accuracy, PresetsErrLessEach) {
    const Scene scene = loadScene(GetParam().source);
    sharedRenderer().load(scene);
    RenderSettings s = settingsFor(GetParam(), scene, 320, 180);
    s.config.technique = "ssaa";
    const Image reference = sharedRenderer().render(s).image;
    s.config.technique = "single";
    const double single = compareImages(reference, sharedRenderer().render(s).image).mseTm;
    struct Figures {
        double share, events;
    };
    const auto measured = [&](const char* preset, AgaaTier tier) {
        agaaApplyPreset(preset, &s.config);
        s.config.generationTier = tier;
        const RenderResult result = sharedRenderer().render(s);
        const AgaaCounters& c = result.statistics.back().counters;
        const Figures f{compareImages(reference, result.image).mseTm / single,
                        double(c.shadingEvents) / double(c.shadedPixels)};
        std::printf("%-24s %-9s mseTm of single's %.4f, events a covered pixel %.2f\n", GetParam().name.c_str(), preset,
                    f.share, f.events);
        return f;
    };
    const Figures paper = measured("paper", AGAA_TIER_AUTO), fast = measured("fast", AGAA_TIER_GBUFFER),
                  balanced = measured("balanced", AGAA_TIER_GBUFFER), accurate = measured("accurate", AGAA_TIER_GBUFFER);
    EXPECT_LT(balanced.share, fast.share);
    EXPECT_LT(accurate.share, balanced.share);
    EXPECT_LT(balanced.share, 0.9 * paper.share);
    EXPECT_LT(accurate.share, 0.4 * paper.share);
    EXPECT_LT(accurate.events, 1.35 * paper.events);
    EXPECT_TRUE(sharedRenderer().takeMessages().empty());
}

// Where normals turn inside a pixel and materials shine narrowly, a few samples miss highlights that the mean over an
// aggregate's normals has: against many samples, elliptic lobes err less than shading each of the same eight.
TEST(PolishedTubes, EllipticLobesErrLessThanShadingEachSample) {
    TestScene metal;
    for (const TestScene& one : allTestScenes())
        if (one.name == "metal")
            metal = one;
    const Scene scene = loadScene(metal.source);
    sharedRenderer().load(scene);
    RenderSettings s = settingsFor(metal, scene, 320, 180);
    const Reference truth = renderReference(sharedRenderer(), s, 256);
    const auto error = [&](const char* what) {
        const double e = compareImages(truth.image, sharedRenderer().render(s).image).mseTm;
        std::printf("%-20s mseTm against 256 samples %.3g (split half %.3g)\n", what, e, truth.splitHalfMseTm);
        return e;
    };
    s.config.technique = "ssaa";
    const double ssaa = error("ssaa");
    agaaApplyPreset("accurate", &s.config);
    s.config.generationTier = AGAA_TIER_IDS;
    const double elliptic = error("accurate by id");
    s.config.ndf = AGAA_NDF_TOKSVIG;
    const double round = error("the same, round");
    EXPECT_GT(ssaa, 10 * truth.splitHalfMseTm);
    EXPECT_LT(elliptic, 0.7 * ssaa);
    EXPECT_LT(elliptic, 0.7 * round);
}

INSTANTIATE_TEST_SUITE_P(All, Accuracy, testing::ValuesIn(allTestScenes()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace harness::test
