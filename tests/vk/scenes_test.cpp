// Every scene through the SDK: each visible sample is accounted for exactly once, images repeat bit by
// bit, and the API's validation stays silent.
#include "support.h"

#include "image/tonemap.h"
#include "scene/gltf.h"
#include "render/messages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace harness::test {
namespace {

constexpr uint32_t width = 192, height = 108;

std::vector<TestScene> allScenes() {
    std::vector<TestScene> scenes = builtinTestScenes();
    for (const TestScene& scene : sharedTestScenes())
        scenes.push_back(scene);
    return scenes;
}

class Scenes : public testing::TestWithParam<TestScene> {
protected:
    void SetUp() override {
        scene_ = loadScene(GetParam().source);
        sharedRenderer().load(scene_);
    }
    void TearDown() override {
        for (const ApiMessage& message : sharedRenderer().takeMessages())
            ADD_FAILURE() << message.severity << " " << message.id << ": " << message.text;
    }
    RenderSettings settings() const { return settingsFor(GetParam(), scene_, width, height); }

    Scene scene_;
};

void expectEverySampleOnce(const AgaaCounters& c) {
    EXPECT_GT(c.visible, 0u);
    EXPECT_EQ(c.once, c.visible);
    EXPECT_EQ(c.missed, 0u);
    EXPECT_EQ(c.multi, 0u);
    EXPECT_EQ(c.sanitised, 0u);
}

TEST_P(Scenes, EveryVisibleSampleIsAccumulatedOnce) {
    RenderSettings s = settings();
    for (const auto& [samples, aggregates] : {std::pair{1u, 1u}, {4u, 2u}, {8u, 2u}, {8u, 3u},
                                              {16u, 4u}, {32u, 2u}}) {
        SCOPED_TRACE(testing::Message() << "n=" << samples << " c=" << aggregates);
        s.config.samples = samples;
        s.config.aggregates = aggregates;
        const RenderResult result = sharedRenderer().render(s);
        const AgaaCounters& c = result.statistics.back().counters;
        expectEverySampleOnce(c);
        EXPECT_LE(c.maxEventsPerPixel, aggregates);
        EXPECT_EQ(result.memory.totalBytes, result.statistics.back().payloadBytes);
        for (float value : result.image.rgb)
            ASSERT_TRUE(std::isfinite(value));
    }
}

// After tone mapping, so that no highlight speaks for the image.
static double meanDifference(const Image& a, const Image& b) {
    double sum = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i)
        sum += std::fabs(toneMap(double(a.rgb[i])) - toneMap(double(b.rgb[i])));
    return sum / double(a.rgb.size());
}

TEST_P(Scenes, TiersAgree) {
    RenderSettings s = settings();
    const Image postDepth = sharedRenderer().render(s).image;
    // Attributes are taken at the sample itself in the one, at the fragment's inside point in the other;
    // in the last, shading normals decide over aggregates in the place of geometric ones.
    for (AgaaTier tier : {AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER}) {
        s.config.generationTier = tier;
        const RenderResult result = sharedRenderer().render(s);
        expectEverySampleOnce(result.statistics.back().counters);
        const double mean = meanDifference(postDepth, result.image);
        std::printf("%-24s %-12s mean difference %.2f/255\n", GetParam().name.c_str(),
                    agaaTierName(tier), 255 * mean);
        EXPECT_LT(mean, 0.3 / 255);
    }
}

TEST_P(Scenes, ImagesRepeatBitByBit) {
    for (const char* technique : {"ssaa", "agaa"}) {
        RenderSettings s = settings();
        s.config.technique = technique;
        const Image first = sharedRenderer().render(s).image;
        for (int i = 0; i < 2; ++i)
            EXPECT_EQ(differenceOf(first, sharedRenderer().render(s).image).pixels, 0u);
    }
}

TEST_P(Scenes, DrawOrderMattersOnlyWhereDepthsTie) {
    RenderSettings s = settings();
    const Image ordered = sharedRenderer().render(s).image;
    s.drawOrderSeed = 7;
    const Image shuffled = sharedRenderer().render(s).image;
    s.config.flags |= AGAA_CONFIG_NO_STENCIL; // the stencil test hides the ties that it refuses
    const AgaaCounters c = sharedRenderer().render(s).statistics.back().counters;
    expectEverySampleOnce(c);
    EXPECT_LE(differenceOf(ordered, shuffled).pixels, c.ties);
}

TEST_P(Scenes, HardCase22_FarFromTheOriginNothingChanges) {
    RenderSettings s = settings();
    const Image near = sharedRenderer().render(s).image;
    s.worldOffset = {1e6, 2e5, -1e6};
    const Image far = sharedRenderer().render(s).image;
    EXPECT_LE(differenceOf(near, far).largest, 1.0 / 255);
}

INSTANTIATE_TEST_SUITE_P(All, Scenes, testing::ValuesIn(allScenes()),
                         [](const auto& info) { return info.param.name; });

TEST(SharedScenes, ArePresent) {
    if (sharedTestScenes().size() < 5)
        GTEST_SKIP() << "only " << sharedTestScenes().size()
                     << " of 5 shared scenes are in $AGAA_SCENES or ../shared/scenes";
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
