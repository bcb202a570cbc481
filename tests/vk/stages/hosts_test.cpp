// Every kind of host gets the same bits.
#include "stage_host.h"

#include <gtest/gtest.h>

namespace agaa::test {
namespace {

AgaaLight sun() {
    AgaaLight light{};
    light.type = AGAA_LIGHT_DIRECTIONAL;
    light.shadowMap = AGAA_NO_SHADOW;
    light.direction[2] = -1;
    light.color[0] = light.color[1] = light.color[2] = 3;
    return light;
}

ViewSettings settingsFor(const char* technique) {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    settings.facts.shadowMapCount = 0;
    return settings;
}

std::vector<float> pixels(const HostOptions& options, const ViewSettings& settings,
                          bool splitSegments = false, uint32_t frames = 1) {
    StageContext context(options);
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 200}, 11));
    const AgaaLight light = sun();
    for (uint32_t i = 0; i < frames; ++i) {
        AgaaFrame frame = view.frame();
        frame.lights = &light;
        frame.lightCount = 1;
        view.render(frame, nullptr, splitSegments);
    }
    return view.image().rgb;
}

class HostsTest : public testing::TestWithParam<const char*> {};

TEST_P(HostsTest, RenderPassesDynamicRenderingAndRecordingAgree) {
    const ViewSettings settings = settingsFor(GetParam());
    const std::vector<float> expected = pixels({}, settings);
    float largest = 0;
    for (float value : expected)
        largest = std::max(largest, value);
    EXPECT_GT(largest, 0.1f) << "there is something to compare";
    EXPECT_EQ(pixels({.renderPass = true}, settings), expected);
    EXPECT_EQ(pixels({.inlineRecording = true}, settings), expected);
    EXPECT_EQ(pixels({.renderPass = true, .inlineRecording = true}, settings), expected);
}

TEST_P(HostsTest, SegmentsInCallsOfTheirOwnAgree) {
    const ViewSettings settings = settingsFor(GetParam());
    const std::vector<float> expected = pixels({}, settings);
    EXPECT_EQ(pixels({}, settings, true), expected);
    EXPECT_EQ(pixels({.renderPass = true, .inlineRecording = true}, settings, true), expected);
}

TEST_P(HostsTest, FramesInFlightAndRepetitionAgree) {
    const ViewSettings settings = settingsFor(GetParam());
    const std::vector<float> expected = pixels({}, settings);
    for (uint32_t inFlight : {1u, 3u, 8u})
        EXPECT_EQ(pixels({.framesInFlight = inFlight}, settings, false, 10), expected);
}

TEST_P(HostsTest, OutputLayoutsAreLeftAsAsked) {
    StageContext context;
    StageView view(context, settingsFor(GetParam()));
    view.setTriangles(randomTriangles({.triangles = 50}, 12));
    // Validation knows the layout that the image is in; reading wants TRANSFER_SRC.
    view.render(view.frame(),
                [](AgaaVkFrame& vk) { vk.outputLayoutOut = VK_IMAGE_LAYOUT_GENERAL; });
    view.render(view.frame(), [](AgaaVkFrame& vk) {
        vk.outputLayoutIn = VK_IMAGE_LAYOUT_GENERAL;
        vk.outputLayoutOut = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    });
    view.render(view.frame(), [](AgaaVkFrame& vk) {
        vk.outputLayoutIn = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    });
    EXPECT_EQ(view.image().rgb.size(), size_t(48 * 32 * 3));
}

INSTANTIATE_TEST_SUITE_P(All, HostsTest, testing::Values("single", "ssaa", "agaa"));

} // namespace
} // namespace agaa::test
