// Every scene through the SDK: each visible sample is accounted for exactly once, images repeat bit by
// bit, and the API's validation stays silent.
#include "moving_scenes.h"
#include "support.h"
#include "texture_sizes.h"

#include "render/messages.h"
#include "scene/gltf.h"

#include <gtest/gtest.h>

namespace harness::test {
namespace {

constexpr uint32_t width = 192, height = 108;

class Scenes : public testing::TestWithParam<TestScene> {
protected:
    void SetUp() override {
        scene_ = loadScene(GetParam().source);
        sharedRenderer().load(scene_);
    }
    void TearDown() override { expectNoMessages(sharedRenderer()); }
    RenderSettings settings() const { return settingsFor(GetParam(), scene_, width, height); }

    Scene scene_;
};

// The shared scenes are large: what the small ones cover in full is sampled on them, to save time.
std::vector<std::pair<uint32_t, uint32_t>> samplesAndAggregates(const TestScene& scene) {
    if (scene.hasCamera)
        return {{8, 2}, {32, 2}};
    return {{1, 1}, {4, 2}, {8, 2}, {8, 3}, {16, 4}, {32, 2}};
}

TEST_P(Scenes, EveryVisibleSampleIsAccumulatedOnce) {
    RenderSettings s = settings();
    for (const auto& [samples, aggregates] : samplesAndAggregates(GetParam())) {
        SCOPED_TRACE(testing::Message() << "n=" << samples << " c=" << aggregates);
        s.config.samples = samples;
        s.config.aggregates = aggregates;
        expectWholeFrame(sharedRenderer().render(s), aggregates);
    }
}

TEST_P(Scenes, TiersAgree) {
    if (GetParam().hasCamera ? !isSampled(GetParam()) : !isInShare(GetParam(), vulkanShare))
        GTEST_SKIP() << otherApi;
    expectTiersAgree(sharedRenderer(), settings(), GetParam().name.c_str());
}

TEST_P(Scenes, WaysAgree) {
    if (!isSceneOf(GetParam(), "bamboo", "metal"))
        GTEST_SKIP() << "bamboo and metal cover it, one on each graphics API";
    expectWaysAgree(sharedRenderer(), settings(), GetParam().name.c_str());
}

TEST_P(Scenes, RivalsAreWhatTheirKindAllows) {
    if (GetParam().hasCamera)
        GTEST_SKIP() << "the built-in scenes cover it";
    expectRivals(sharedRenderer(), settings(), GetParam().name.c_str());
}

TEST_P(Scenes, ImagesRepeatBitByBit) {
    if (GetParam().name != "bamboo" && !isInShare(GetParam(), vulkanShare)) // bamboo repeats every tier here
        GTEST_SKIP() << otherApi;
    expectImagesRepeat(sharedRenderer(), settings(), GetParam().name == "bamboo");
}

// Hard case 35.
TEST_P(Scenes, DrawOrderMattersOnlyWhereDepthsTie) {
    if (!isSampled(GetParam()))
        GTEST_SKIP() << "scripts/test --exhaustive covers every second shared scene";
    RenderSettings s = settings();
    const Image ordered = sharedRenderer().render(s).image;
    s.drawOrderSeed = 7;
    const Image shuffled = sharedRenderer().render(s).image;
    s.config.measurement.flags |= AGAA_MEASURE_NO_STENCIL; // the stencil test hides the ties that it refuses
    const AgaaCounters c = sharedRenderer().render(s).statistics.back().counters;
    expectEverySampleOnce(c);
    EXPECT_LE(differenceOf(ordered, shuffled).pixels, c.ties);
}

TEST_P(Scenes, OrderOfDrawsIsFreeInOneGeometryPass) {
    if (!isSceneOf(GetParam(), "foliage", "metal"))
        GTEST_SKIP() << "foliage and metal cover it, one on each graphics API";
    expectOrderOfDrawsIsFree(sharedRenderer(), settings());
}

TEST_P(Scenes, VertexPullingShowsWhatGeometryShadersShow) {
    if (GetParam().name != "foliage" && GetParam().name != "city")
        GTEST_SKIP() << "foliage and city cover it";
    RendererOptions options;
    options.noGeometryShaders = true;
    const std::unique_ptr<Renderer> pulling = makeVulkanRenderer(options);
    pulling->load(scene_);
    EXPECT_EQ(pulling->caps().flags & AGAA_DEVICE_GEOMETRY_SHADERS, 0u);
    expectExpansionsAgree(sharedRenderer(), *pulling, settings(), GetParam().name == "city");
    RenderSettings refused = settings();
    refused.config.technique = "dcaa";
    refused.config.samples = 64;
    EXPECT_THROW(pulling->render(refused), std::runtime_error);
    expectNoMessages(*pulling);
}

TEST_P(Scenes, HardCase22_FarFromTheOriginNothingChanges) {
    if (!isSampled(GetParam()))
        GTEST_SKIP() << "scripts/test --exhaustive covers every second shared scene";
    expectSameFarFromTheOrigin(sharedRenderer(), settings());
}

INSTANTIATE_TEST_SUITE_P(All, Scenes, testing::ValuesIn(allTestScenes()),
                         [](const auto& info) { return info.param.name; });

TEST(SharedScenes, ArePresent) { expectSharedScenes(); }

TEST(MovingScenes, ImagesOfTheMotionShowWhereSurfacesWere) {
    expectMotionIsShown(sharedRenderer());
    expectNoMessages(sharedRenderer());
}

TEST(MovingScenes, AccumulationFollowsMotion) {
    RendererOptions options;
    options.keptViews = 4; // histories
    options.shadowMapSize = 512;
    const std::unique_ptr<Renderer> renderer = makeVulkanRenderer(options);
    expectAccumulationFollowsMotion(*renderer);
    expectNoMessages(*renderer);
}

TEST(TextureSizes, ById) {
    expectTextureSizesAgree(sharedRenderer());
    expectNoMessages(sharedRenderer());
}

// At the end of the process: an entry that excuses nothing has outlived its reason.
class AllowList : public testing::Environment {
    void TearDown() override {
        if (std::string(sharedRenderer().caps().driverName).find("Mesa") == std::string::npos)
            return; // the list is for Mesa's drivers
        for (const AllowedMessage& entry : allowedMessages())
            EXPECT_TRUE(entry.isUsed) << "unused: " << entry.id << ": " << entry.reason;
    }
};
const testing::Environment* const allowList = testing::AddGlobalTestEnvironment(new AllowList);

} // namespace
} // namespace harness::test
