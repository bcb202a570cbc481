// Every kind of host gets the same bits.
#include "dcaa_cases.h"
#include "show.h"
#include "truth.h"

#include "render/messages.h"
#include "vk/barrier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstring>

namespace agaa::test {
namespace {

ViewSettings settingsOf(const char* technique) {
    ViewSettings settings;
    settings.config.technique = technique;
    settings.config.flags = AGAA_CONFIG_COUNTERS;
    settings.facts.shadowMapCount = 0;
    return settings;
}

std::vector<float> pixels(const HostOptions& options, const ViewSettings& settings, bool splitSegments = false,
                          uint32_t frames = 1) {
    StageContext context(options);
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 200}, 11));
    const AgaaLight light = sun();
    for (uint32_t i = 0; i < frames; ++i) {
        AgaaFrame frame = view.frame();
        setLight(frame, light);
        view.render(frame, nullptr, splitSegments);
    }
    return view.image().rgb;
}

class HostsTest : public testing::TestWithParam<const char*> {};

TEST_P(HostsTest, RenderPassesDynamicRenderingAndRecordingAgree) {
    const ViewSettings settings = settingsOf(GetParam());
    const std::vector<float> expected = pixels({}, settings);
    float largest = 0;
    for (float value : expected)
        largest = std::max(largest, value);
    EXPECT_GT(largest, 0.1f) << "there is something to compare";
    EXPECT_EQ(pixels({.renderPass = true}, settings), expected);
    EXPECT_EQ(pixels({.inlineRecording = true}, settings), expected);
    EXPECT_EQ(pixels({.renderPass = true, .inlineRecording = true}, settings), expected);
}

// Where shaders read attachments, contexts with dynamic rendering have a render pass, too.
TEST(Hosts, AttachmentsThatShadersReadAgree) {
    StageContext context;
    if (!(context.caps().flags & AGAA_DEVICE_FRAMEBUFFER_FETCH))
        GTEST_SKIP() << "the device does not order what shaders read of attachments";
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    ASSERT_EQ(agaaGetBuiltinLayout("dcaa28", &layout), AGAA_OK);
    ViewSettings settings = dcaaSettings(64, 4, AGAA_TIER_RASTER_ORDER);
    settings.config.layout = &layout;
    const std::vector<float> expected = pixels({}, settings);
    EXPECT_GT(std::ranges::max(expected), 0.1f) << "there is something to compare";
    for (const bool renderPass : {false, true})
        for (const bool inlineRecording : {false, true})
            EXPECT_EQ(pixels({.renderPass = renderPass, .inlineRecording = inlineRecording}, settings, true), expected);
    StageView view(context, settings);
    AgaaVkSurface native = AGAA_VK_SURFACE_INIT;
    AgaaSurface surface = AGAA_SURFACE_INIT;
    surface.pNext = &native;
    ASSERT_EQ(agaaGetSurface(view.get(), "surfaces", &surface), AGAA_OK);
    EXPECT_EQ(surface.layers, 7u);
    EXPECT_EQ(native.format, uint32_t(VK_FORMAT_R32G32B32A32_UINT));
    EXPECT_EQ(native.view, uint64_t((*view.executor().resources)[view.plan().surface("surfaces")].fetchView));
    EXPECT_EQ(native.layouts[0], uint32_t(VK_IMAGE_LAYOUT_GENERAL));
    StageContext unknown({.change = [](auto& desc) { desc.device.enabledFeatures = nullptr; }});
    expectRefused(unknown, settings, AGAA_ERROR_UNSUPPORTED, "the host does not say that it enabled the feature");
}

TEST_P(HostsTest, SegmentsInCallsOfTheirOwnAgree) {
    const ViewSettings settings = settingsOf(GetParam());
    const std::vector<float> expected = pixels({}, settings);
    EXPECT_EQ(pixels({}, settings, true), expected);
    EXPECT_EQ(pixels({.renderPass = true, .inlineRecording = true}, settings, true), expected);
}

TEST_P(HostsTest, FramesInFlightAndRepetitionAgree) {
    const ViewSettings settings = settingsOf(GetParam());
    const std::vector<float> expected = pixels({}, settings);
    for (uint32_t inFlight : {1u, 3u, 8u})
        EXPECT_EQ(pixels({.framesInFlight = inFlight}, settings, false, 10), expected);
}

// Two frames of which neither waits for the other: each has its own lights, shadows, output and counts.
TEST_P(HostsTest, FramesInFlightKeepWhatIsTheirs) {
    ViewSettings settings = settingsOf(GetParam());
    settings.facts.shadowMapCount = 1;
    StageContext context;
    const ShadowLayers shadow({0.0f}, 4);
    AgaaShadow map{};
    map.layerCount = 1;
    map.matrices[0][14] = 0.5f; // all points, behind what the map holds
    map.matrices[0][15] = 1;
    AgaaLight lights[2] = {sun(), sun()};
    lights[0].color[0] = 0;
    lights[1].shadowMap = 0;
    const auto describe = [&](StageView& view, int which) {
        AgaaFrame frame = view.frame();
        frame.lights = lights;
        frame.lightCount = 1 + which;
        frame.shadows = &map;
        frame.shadowCount = which;
        frame.ambient[which] = 0.5f;
        return frame;
    };
    const auto lend = [&](AgaaVkFrame& vk) { vk.shadowViews[0] = shadow.view(); };
    std::vector<float> alone[2];
    AgaaCounters counts[2];
    for (int which : {0, 1}) {
        StageView view(context, settings);
        view.setTriangles(randomTriangles({.triangles = 200}, 11));
        view.render(describe(view, which), lend);
        alone[which] = view.image().rgb;
        counts[which] = view.statistics().counters;
    }
    EXPECT_NE(alone[0], alone[1]);
    EXPECT_NE(counts[0].shadowTaps, counts[1].shadowTaps);
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 200}, 11));
    const harness::vk::OutputImage other(sharedDevice(), settings.width, settings.height);
    sharedDevice().runCommands([&](VkCommandBuffer commands) {
        for (int which : {0, 1}) {
            AgaaFrame frame = describe(view, which);
            frame.completedFrame = 0;
            AgaaVkFrame vk = view.vkFrame(commands);
            lend(vk);
            if (which == 0) {
                vk.outputImage = (uint64_t)other.image();
                vk.outputView = (uint64_t)other.view();
            }
            EXPECT_EQ(agaaVkRecordFrame(view.get(), &frame, &vk), AGAA_OK);
        }
    });
    EXPECT_EQ(other.read().rgb, alone[0]);
    EXPECT_EQ(view.image().rgb, alone[1]);
    for (uint64_t which : {0, 1}) {
        AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
        ASSERT_EQ(agaaGetFrameStatistics(view.get(), which + 1, &statistics), AGAA_OK);
        EXPECT_EQ(statistics.frameIndex, which + 1);
        EXPECT_EQ(std::memcmp(&statistics.counters, &counts[which], sizeof(AgaaCounters)), 0);
    }
}

bool hasTimestamps() {
    const harness::vk::Device& device = sharedDevice();
    uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(device.physicalDevice(), &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(device.physicalDevice(), &count, families.data());
    return families[device.queueFamily()].timestampValidBits != 0;
}

// The times of its passes are in the time that the frame took.
TEST_P(HostsTest, PassesAreTimed) {
    if (!hasTimestamps())
        GTEST_SKIP() << "the queue family has no timestamps";
    ViewSettings settings = settingsOf(GetParam());
    for (const bool timed : {false, true}) {
        settings.config.flags = timed ? AGAA_CONFIG_TIMESTAMPS : 0;
        StageContext context;
        StageView view(context, settings);
        view.setTriangles(randomTriangles({.triangles = 200}, 11));
        const auto begin = std::chrono::steady_clock::now();
        view.render(view.frame());
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
        const AgaaFrameStatistics statistics = view.statistics();
        EXPECT_EQ(statistics.timeSource, uint32_t(timed ? AGAA_TIME_DEVICE : AGAA_TIME_NONE));
        ASSERT_GT(statistics.passCount, 0u);
        double sum = 0;
        for (uint32_t i = 0; i < statistics.passCount; ++i) {
            EXPECT_EQ(statistics.passes[i].isTimed, uint32_t(timed)) << statistics.passes[i].name;
            EXPECT_GE(statistics.passes[i].milliseconds, 0.0) << statistics.passes[i].name;
            sum += statistics.passes[i].milliseconds;
        }
        EXPECT_EQ(sum > 0, timed);
        EXPECT_LE(sum, took.count());
    }
}

TEST_P(HostsTest, OutputLayoutsAreLeftAsAsked) {
    StageContext context;
    StageView view(context, settingsOf(GetParam()));
    view.setTriangles(randomTriangles({.triangles = 50}, 12));
    // Validation knows the layout that the image is in; reading wants TRANSFER_SRC.
    view.render(view.frame(), [](AgaaVkFrame& vk) { vk.outputLayoutOut = VK_IMAGE_LAYOUT_GENERAL; });
    view.render(view.frame(), [](AgaaVkFrame& vk) {
        vk.outputLayoutIn = VK_IMAGE_LAYOUT_GENERAL;
        vk.outputLayoutOut = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    });
    view.render(view.frame(), [](AgaaVkFrame& vk) { vk.outputLayoutIn = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL; });
    EXPECT_EQ(view.image().rgb.size(), size_t(48 * 32 * 3));
}

// What the output held shows where nothing is drawn, and in part where something is.
TEST_P(HostsTest, CompositesOverTheOutput) {
    StageContext context;
    ViewSettings settings = settingsOf(GetParam());
    settings.facts.maxLights = 1;
    const AgaaLight light = sun();
    const auto render = [&](StageView& view, bool composite, uint32_t layoutIn) {
        AgaaFrame frame = view.frame();
        const float below[4] = {0.25f, 0.5f, 2.0f, 1};
        for (int i = 0; i < 4; ++i)
            frame.background[i] = composite ? 0 : below[i];
        setLight(frame, light);
        view.render(frame, [&](AgaaVkFrame& vk) { vk.outputLayoutIn = layoutIn; });
    };
    const auto scene = randomTriangles({.triangles = 50}, 16);
    StageView plain(context, settings);
    plain.setTriangles(scene);
    render(plain, false, VK_IMAGE_LAYOUT_UNDEFINED);
    settings.flags |= AGAA_VIEW_COMPOSITE;
    StageView view(context, settings);
    view.setTriangles({});
    render(view, false, VK_IMAGE_LAYOUT_UNDEFINED); // fills the output
    view.setTriangles(scene);
    render(view, true, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    EXPECT_EQ(view.image().rgb, plain.image().rgb);
}

// The host reads the depth between the prepass and the rest.
TEST_P(HostsTest, DepthCanBeReadBetweenSegments) {
    StageContext context;
    ViewSettings settings = settingsOf(GetParam());
    settings.config.flags |= AGAA_CONFIG_READBACK;
    StageView view(context, settings);
    view.setTriangles(randomTriangles({.triangles = 200}, 13));
    AgaaVkSurface surface = AGAA_VK_SURFACE_INIT;
    AgaaSurface common = AGAA_SURFACE_INIT;
    common.pNext = &surface;
    ASSERT_EQ(agaaGetSurface(view.get(), "depth", &common), AGAA_OK);
    EXPECT_EQ(common.width, 48 * common.scaleX);
    EXPECT_EQ(common.height, 32 * common.scaleY);
    const auto image = (VkImage)surface.image;
    constexpr VkImageAspectFlags aspects = VK_IMAGE_ASPECT_DEPTH_BIT | VK_IMAGE_ASPECT_STENCIL_BIT;
    const auto use = [&](uint32_t layout) {
        return harness::vk::ImageUse{VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                                     VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT, VkImageLayout(layout)};
    };
    const auto readable = use(VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL);
    const AgaaLight light = sun();
    AgaaFrame frame = view.frame();
    setLight(frame, light);
    const auto record = [&](uint64_t segments) {
        sharedDevice().runCommands([&](VkCommandBuffer commands) {
            AgaaVkFrame vk = view.vkFrame(commands);
            if (segments != AGAA_SEGMENT_PREPASS)
                harness::vk::imageBarrier(commands, image, aspects, readable, use(surface.layouts[0]));
            frame.segments = segments;
            ASSERT_EQ(agaaVkRecordFrame(view.get(), &frame, &vk), AGAA_OK);
            const bool isFirst = segments == AGAA_SEGMENT_PREPASS;
            harness::vk::imageBarrier(commands, image, aspects, use(surface.layouts[isFirst ? 0 : 2]), readable);
        });
    };
    record(AGAA_SEGMENT_PREPASS);
    const auto between = view.readSurface("depth");
    record(AGAA_SEGMENT_GENERATION | AGAA_SEGMENT_SHADING);
    EXPECT_EQ(between, view.readSurface("depth"));
    EXPECT_EQ(view.image().rgb, [&] {
        StageView whole(context, settings);
        whole.setTriangles(randomTriangles({.triangles = 200}, 13));
        AgaaFrame again = whole.frame();
        setLight(again, light);
        whole.render(again);
        return whole.image().rgb;
    }());
    EXPECT_EQ(agaaGetSurface(view.get(), "nothing", &common), AGAA_ERROR_INVALID_ARGUMENT);
}

// Hard case 35: if no two triangles tie, the order of drawing changes no bit.
TEST_P(HostsTest, ShufflingChangesOnlyPixelsOfTies) {
    if (std::string(GetParam()) == "fxaa")
        GTEST_SKIP() << "a filter carries ties to pixels around them";
    StageContext context;
    ViewSettings settings = settingsOf(GetParam());
    settings.config.adaptive.flags = AGAA_ADAPTIVE_GEOMETRY; // the other metric compares pixels with their neighbours
    std::vector<Triangle> scene = randomTriangles({.triangles = 200, .duplicates = 0.1f, .masked = 0.2f}, 14);
    std::vector<Triangle> shuffled = scene;
    for (size_t i = 0; i < scene.size(); ++i)
        scene[i].seed = shuffled[i].seed = uint32_t(i + 1);
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(15));
    const auto rendered = [&](const std::vector<Triangle>& triangles) {
        StageView view(context, settings);
        view.setTriangles(triangles);
        const AgaaLight light = sun();
        AgaaFrame frame = view.frame();
        setLight(frame, light);
        view.render(frame);
        return view.image().rgb;
    };
    const std::vector<float> first = rendered(scene), second = rendered(shuffled);
    ViewSettings like = settings;
    if (std::string(GetParam()) == "single")
        like.config.samples = 1;
    const Truth a = visibleTriangles<VulkanHost>(context, like, scene);
    const Truth b = visibleTriangles<VulkanHost>(context, like, shuffled);
    size_t ties = 0, different = 0;
    for (size_t pixel = 0; pixel < first.size() / 3; ++pixel) {
        bool tie = false;
        for (uint32_t i = 0; i < a.samples; ++i) {
            const uint32_t ta = a.triangle[pixel * a.samples + i];
            const uint32_t tb = b.triangle[pixel * b.samples + i];
            const bool hitA = ta != noTriangle, hitB = tb != noTriangle;
            tie |= hitA != hitB || (hitA && scene[ta].seed != shuffled[tb].seed);
        }
        const bool differs = !std::equal(&first[3 * pixel], &first[3 * pixel] + 3, &second[3 * pixel]);
        ties += tie;
        different += differs;
        EXPECT_TRUE(tie || !differs) << "pixel " << pixel;
    }
    EXPECT_GT(ties, 0u) << "the scene must have ties";
    EXPECT_LE(different, ties);
}

// Silence means something only where someone listens.
TEST(Validation, HearsHazards) {
    ASSERT_TRUE(sharedDevice().hasValidation());
    harness::vk::Arena arena(sharedDevice());
    const harness::vk::BufferResource twice = arena.deviceBuffer(64, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    const VkCommandBuffer commands = sharedDevice().beginCommands();
    for (uint32_t value = 0; value < 2; ++value)
        vkCmdFillBuffer(commands, twice.buffer.get(), 0, 64, value);
    sharedDevice().submitAndWait(commands);
    const auto messages = sharedDevice().takeMessages();
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0].id, "SYNC-HAZARD-WRITE-AFTER-WRITE");
}

TEST(Validation, TellsOfObjectsThatAreLeft) {
    {
        const harness::vk::Device device{harness::RendererOptions{}};
        VkSamplerCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
        VkSampler left = VK_NULL_HANDLE;
        ASSERT_EQ(vkCreateSampler(device.get(), &info, nullptr, &left), VK_SUCCESS);
    }
    const auto messages = harness::takeLeftoverMessages();
    ASSERT_FALSE(messages.empty());
    EXPECT_NE(messages[0].text.find("has not been destroyed"), std::string::npos) << messages[0].text;
}

INSTANTIATE_TEST_SUITE_P(All, HostsTest,
                         testing::Values("single", "fxaa", "msaa", "ssaa", "simple_complex", "sbaa", "agaa",
                                         "adaptive"));

} // namespace
} // namespace agaa::test
