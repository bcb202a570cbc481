// Every scene through the SDK on OpenGL: what holds on Vulkan holds here, and the images are the same.
#include "moving_scenes.h"
#include "support.h"
#include "texture_sizes.h"

#include "image/tonemap.h"
#include "scene/gltf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace harness::test {
namespace {

constexpr uint32_t width = 192, height = 108;

Renderer& sharedVulkanRenderer() {
    static const std::unique_ptr<Renderer> renderer = makeVulkanRenderer(RendererOptions{});
    return *renderer;
}

class GlScenes : public testing::TestWithParam<TestScene> {
protected:
    void SetUp() override {
        scene_ = loadScene(GetParam().source);
        sharedGlRenderer().load(scene_);
    }
    void TearDown() override { expectNoMessages(sharedGlRenderer()); }
    RenderSettings settings() const { return settingsFor(GetParam(), scene_, width, height); }

    Scene scene_;
};

struct Row {
    const char* technique;
    uint32_t samples, aggregates;
    double share = 0.001; // of pixels that may differ by more than 4/255
    uint32_t tier = AGAA_TIER_AUTO;
    const char* preset = ""; // that decides in the row's place
};

// The shared scenes are large: what the small ones cover in full is sampled on them, to save time.
std::vector<Row> rowsOf(const TestScene& scene) {
    if (scene.hasCamera)
        return {{"ssaa", 8, 1}, {"agaa", 8, 2}, {"agaa", 32, 4}, {"agaa", 8, 4, 0.001, AGAA_TIER_IDS, "accurate"}};
    return {{"single", 1, 1},
            {"ssaa", 8, 1},
            {"agaa", 2, 2},
            {"agaa", 4, 1},
            {"agaa", 8, 2},
            {"agaa", 16, 3},
            {"agaa", 32, 4},
            {"msaa", 8, 1},
            {"agaa", 8, 2, 0.001, AGAA_TIER_IDS},
            {"agaa", 8, 2, 0.001, AGAA_TIER_GBUFFER},
            {"agaa", 8, 4, 0.001, AGAA_TIER_IDS, "accurate"},
            {"agaa", 8, 4, 0.001, AGAA_TIER_GBUFFER, "accurate"},
            {"sbaa", 8, 2},
            {"sbaa", 32, 6},
            {"simple_complex", 16, 1},
            {"adaptive", 9, 1},
            {"dcaa", 64, 4},
            {"agaa", 64, 4, 0.001, AGAA_TIER_FRAGMENTS, "accurate"},
            {"fxaa", 1, 1, 0.005}}; // it decides at thresholds, where last bits tell
}

// One view a row: the frame is checked by itself and against Vulkan's. Every second row is rendered, others in the next
// scene.
TEST_P(GlScenes, EverySampleCountsOnceAndVulkanAgrees) {
    if (!isSampled(GetParam()))
        GTEST_SKIP() << "scripts/test --exhaustive covers every second shared scene";
    sharedVulkanRenderer().load(scene_);
    for (size_t setting = sceneNumber(GetParam().name); const Row& row : rowsOf(GetParam())) {
        if (!GetParam().hasCamera && !rendersSetting(setting++))
            continue;
        SCOPED_TRACE(testing::Message() << row.technique << " n=" << row.samples << " c=" << row.aggregates << ' '
                                        << row.preset);
        RenderSettings s = settings();
        s.config.technique = row.technique;
        s.config.samples = row.samples;
        s.config.aggregates = row.aggregates;
        s.config.generationTier = row.tier;
        s.config.coverage.fragmentsPerPixel = 128; // small images of dense scenes have many
        if (*row.preset) {
            ASSERT_EQ(s.config.applyPreset(row.preset), AGAA_OK);
        }
        const RenderResult gl = sharedGlRenderer().render(s);
        const std::string_view technique = row.technique;
        const bool aggregates = technique == "agaa" || technique == "sbaa" || technique == "dcaa";
        expectWholeFrame(gl, aggregates ? row.aggregates : row.samples);
        const RenderResult vk = sharedVulkanRenderer().render(s);
        const double mean = meanDifference(gl.image, vk.image);
        const double share = shareAbove(gl.image, vk.image, 4.0 / 255);
        std::printf("%-24s %-6s n=%-2u c=%u %s %s: OpenGL against Vulkan, mean %.4f/255, above 4/255 %.4f %%\n",
                    GetParam().name.c_str(), row.technique, row.samples, row.aggregates, agaaTierName(row.tier),
                    row.preset, 255 * mean, 100 * share);
        EXPECT_LE(mean, 0.5 / 255);
        EXPECT_LE(share, row.share);
    }
}

TEST_P(GlScenes, TiersAgree) {
    if (!isInShare(GetParam(), openGlShare))
        GTEST_SKIP() << otherApi;
    expectTiersAgree(sharedGlRenderer(), settings(), GetParam().name.c_str());
}

TEST_P(GlScenes, WaysAgree) {
    if (!isSceneOf(GetParam(), "metal", "bamboo"))
        GTEST_SKIP() << "metal and bamboo cover it, one on each graphics API";
    expectWaysAgree(sharedGlRenderer(), settings(), GetParam().name.c_str());
}

TEST_P(GlScenes, ImagesRepeatBitByBit) {
    if (!isInShare(GetParam(), openGlShare))
        GTEST_SKIP() << otherApi;
    // Vulkan repeats every tier.
    expectImagesRepeat(sharedGlRenderer(), settings(), GetParam().name == "bamboo" && rendersSetting(1));
}

TEST_P(GlScenes, OrderOfDrawsIsFreeInOneGeometryPass) {
    if (!isSceneOf(GetParam(), "metal", "foliage"))
        GTEST_SKIP() << "metal and foliage cover it, one on each graphics API";
    expectOrderOfDrawsIsFree(sharedGlRenderer(), settings());
}

TEST_P(GlScenes, HardCase22_FarFromTheOriginNothingChanges) {
    if (GetParam().name != "city")
        GTEST_SKIP() << "city covers it, Vulkan covers the other scenes";
    expectSameFarFromTheOrigin(sharedGlRenderer(), settings());
}

TEST_P(GlScenes, VertexPullingShowsWhatGeometryShadersShow) {
    if (GetParam().name != "foliage" && GetParam().name != "city")
        GTEST_SKIP() << "foliage and city cover it";
    expectExpansionsAgree(sharedGlRenderer(), sharedGlRenderer(), settings(), GetParam().name != "city");
}

INSTANTIATE_TEST_SUITE_P(All, GlScenes, testing::ValuesIn(allTestScenes()),
                         [](const auto& info) { return info.param.name; });

TEST(SharedScenes, ArePresent) { expectSharedScenes(); }

TEST(MovingScenes, ImagesOfTheMotionShowWhereSurfacesWere) {
    expectMotionIsShown(sharedGlRenderer());
    expectNoMessages(sharedGlRenderer());
}

TEST(MovingScenes, AccumulationFollowsMotion) {
    RendererOptions options;
    options.keptViews = 4; // histories
    options.shadowMapSize = 512;
    const std::unique_ptr<Renderer> renderer = makeGlRenderer(options);
    expectAccumulationFollowsMotion(*renderer);
    expectNoMessages(*renderer);
}

TEST(TextureSizes, ById) {
    expectTextureSizesAgree(sharedGlRenderer());
    expectNoMessages(sharedGlRenderer());
}

} // namespace
} // namespace harness::test
