// Error of aggregated shading against shading every one of the same samples.
#include "support.h"

#include "image/metrics.h"
#include "scene/gltf.h"
#include "render/reference.h"

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
        std::printf("%-24s %-11s mseTm single %.3g; of it c=1 %.4f, c=2 %.4f, c=4 %.4f\n", GetParam().name.c_str(),
                    what, e.single, e.one / e.single, e.two / e.single, e.four / e.single);
    }
};

TEST_P(Accuracy, MoreAggregatesErrLessAndTwoErrATenthOfSingle) {
    if (!isSampled(GetParam()))
        GTEST_SKIP() << "scripts/test --exhaustive covers every second shared scene";
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
// `paper` more than the last two. On scenes with masks `accurate` by id errs at most twice as much.
TEST_P(Accuracy, PresetsErrLessEach) {
    if (!isSampled(GetParam()))
        GTEST_SKIP() << "scripts/test --exhaustive covers every second shared scene";
    const Scene scene = loadScene(GetParam().source);
    sharedRenderer().load(scene);
    RenderSettings s = settingsFor(GetParam(), scene, 320, 180);
    s.config.technique = "ssaa";
    const AgaaLayout wide = referenceLayout(nullptr); // materials by id are not rounded
    s.config.layout = &wide;
    const Image reference = sharedRenderer().render(s).image;
    s.config.layout = nullptr;
    s.config.technique = "single";
    const double single = compareImages(reference, sharedRenderer().render(s).image).mseTm;
    struct Figures {
        double share, events;
    };
    const auto measured = [&](const char* preset, AgaaTier tier) {
        s.config.applyPreset(preset);
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
                  balanced = measured("balanced", AGAA_TIER_GBUFFER),
                  accurate = measured("accurate", AGAA_TIER_GBUFFER);
    EXPECT_LT(balanced.share, fast.share);
    EXPECT_LT(accurate.share, balanced.share);
    EXPECT_LT(balanced.share, 0.9 * paper.share);
    EXPECT_LT(accurate.share, 0.4 * paper.share);
    EXPECT_LT(accurate.events, 1.35 * paper.events);
    if (s.facts.flags & AGAA_FACT_ALPHA_MASKED) {
        EXPECT_LT(measured("accurate", AGAA_TIER_IDS).share, 2 * accurate.share);
    }
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
    s.config.applyPreset("accurate");
    s.config.generationTier = AGAA_TIER_IDS;
    const double elliptic = error("accurate by id");
    s.config.ndf = AGAA_NDF_TOKSVIG;
    const double round = error("the same, round");
    EXPECT_GT(ssaa, 10 * truth.splitHalfMseTm);
    EXPECT_LT(elliptic, (isSoftware(sharedRenderer()) ? 0.7 : 0.75) * ssaa); // 0.72 on an NVIDIA H200
    EXPECT_LT(elliptic, 0.7 * round);
}

// Fragments at 64 coverage samples, grouped by the preset `accurate`, err less than eight samples that are each shaded;
// with lit shadows, lobes along thin tubes and cut-outs.
TEST(FragmentsAtCoverageSamples, ErrLessThanEightShadedSamples) {
    for (const char* name : {"metal", "foliage"}) {
        const Scene scene = loadScene(name);
        sharedRenderer().load(scene);
        RenderSettings s = settingsFor({name, name, {}}, scene, 160, 90);
        s.alphaPoints = 4;
        const Reference truth = renderReference(sharedRenderer(), s, 128);
        const auto error = [&] { return compareImages(truth.image, sharedRenderer().render(s).image).mseTm; };
        s.config.technique = "ssaa";
        s.config.samples = 8;
        const double eight = error();
        ASSERT_EQ(s.config.applyPreset("accurate"), AGAA_OK);
        s.config.samples = 64;
        s.config.generationTier = AGAA_TIER_FRAGMENTS;
        s.config.coverage.fragmentsPerPixel = 64;
        const double fragments = error();
        std::printf("%s: mseTm of fragments %.3g, %.2f of ssaa 8, whose reference has %.3g\n", name, fragments,
                    fragments / eight, truth.splitHalfMseTm);
        EXPECT_LE(fragments, 0.6 * eight);
        EXPECT_TRUE(sharedRenderer().takeMessages().empty());
    }
}

// Normals of vertices face the viewer and away in turn, so that they turn fast inside each triangle and cross length 0.
TEST(TurningNormals, AccurateByIdHasNoFireflies) {
    constexpr int cells = 40;
    Scene scene;
    scene.name = "turning normals";
    scene.materials.emplace_back();
    scene.materials[0].roughness = 0.1f;
    scene.materials[0].doubleSided = true;
    for (int y = 0; y <= cells; ++y)
        for (int x = 0; x <= cells; ++x) {
            Vertex v;
            v.position = glm::vec3(2 * x - cells, 2 * y - cells, 0) / float(cells);
            v.normal = glm::vec3(0, 0, (x + y) % 2 ? 1 : -1);
            scene.vertices.push_back(v);
        }
    for (uint32_t y = 0; y < cells; ++y)
        for (uint32_t x = 0; x < cells; ++x) {
            const uint32_t a = y * (cells + 1) + x, b = a + cells + 1;
            for (const uint32_t index : {a, a + 1, b, a + 1, b + 1, b})
                scene.indices.push_back(index);
        }
    scene.meshes.push_back({0, uint32_t(scene.indices.size()), 0, uint32_t(scene.vertices.size()), 0});
    scene.instances.push_back({0});
    updateBounds(scene);
    sharedRenderer().load(scene);
    TestScene test;
    test.hasCamera = true;
    test.camera.eye = {0.3, 0.2, 1.5};
    RenderSettings s = settingsFor(test, scene, 160, 90);
    s.config.technique = "ssaa";
    s.config.samples = 8;
    const Image reference = sharedRenderer().render(s).image;
    const auto energy = [](const Image& image) {
        double sum = 0;
        for (const float value : image.rgb)
            sum += double(value);
        return sum;
    };
    s.config.applyPreset("accurate");
    for (const AgaaTier tier : {AGAA_TIER_GBUFFER, AGAA_TIER_IDS}) {
        s.config.generationTier = tier;
        const Image image = sharedRenderer().render(s).image;
        const double psnr = compareImages(reference, image).psnr, share = energy(image) / energy(reference);
        std::printf("%s: PSNR %.1f dB, energy %.3f of ssaa's\n", agaaTierName(tier), psnr, share);
        EXPECT_GE(psnr, 40);
        EXPECT_NEAR(share, 1, 0.03);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Accuracy, testing::ValuesIn(allTestScenes()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace harness::test
