// Functions that need no device, through the C++ header and the library.
#include "agaa_gl.hpp"
#include "agaa_vk.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

struct Message {
    AgaaSeverity severity;
    AgaaResult code;
    std::string text;
};

struct Queries : testing::Test {
    Queries() {
        view.width = 640, view.height = 360;
        view.config = &config;
        view.facts = &facts;
    }

    AgaaConfig config = agaa::init<AgaaConfig>();
    AgaaSceneFacts facts = agaa::init<AgaaSceneFacts>();
    AgaaViewDesc view = agaa::init<AgaaViewDesc>();
    std::vector<Message> messages;
    struct Keep {
        std::vector<Message>& messages;
        void operator()(AgaaSeverity severity, AgaaResult code, std::string_view text) noexcept {
            messages.push_back({severity, code, std::string(text)});
        }
    };
    agaa::LogSink<Keep> sink{Keep{messages}};
    const AgaaLog* log = sink.get();
};

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

TEST_F(Queries, Names) {
    EXPECT_TRUE(contains(*agaa::getNames(AGAA_NAMES_TECHNIQUES), "simple_complex"));
    EXPECT_TRUE(contains(*agaa::getNames(AGAA_NAMES_TIERS), agaa::tierName(AGAA_TIER_GBUFFER)));
    EXPECT_TRUE(contains(*agaa::getNames(AGAA_NAMES_STAGES), agaa::stageName(AGAA_STAGE_PREPASS)));
    EXPECT_EQ(agaa::getNames(99).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::tierFromName("post_depth_atomics").value(), uint32_t(AGAA_TIER_POST_DEPTH_ATOMICS));
    EXPECT_EQ(agaa::tierFromName("none").code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::tierName(999), "unknown");
}

TEST_F(Queries, LayoutsAndPresets) {
    const agaa::Result<AgaaLayout> layout = agaa::getBuiltinLayout("precise");
    ASSERT_TRUE(layout);
    EXPECT_GT(layout->attributeCount, 0u);
    EXPECT_EQ(agaa::getBuiltinLayout("none").code(), AGAA_ERROR_LAYOUT);
    AgaaAggregation aggregation = agaa::init<AgaaAggregation>();
    AgaaMeasurement measurement = agaa::init<AgaaMeasurement>();
    EXPECT_EQ(agaa::applyPreset("fast", config, aggregation), AGAA_OK);
    EXPECT_EQ(agaa::applyPreset("paper", config, aggregation), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::applyPreset("paper", config, aggregation, &measurement), AGAA_OK);
    EXPECT_EQ(agaa::applyPreset("none", config, aggregation), AGAA_ERROR_INVALID_ARGUMENT);
}

TEST_F(Queries, Jitter) {
    EXPECT_EQ(agaa::getJitter(0, 2).value(), (std::array<float, 2>{0.25f, 0.25f}));
    EXPECT_EQ(agaa::getJitter(1, 2).value(), (std::array<float, 2>{-0.25f, -0.25f}));
    EXPECT_EQ(agaa::getJitter(0, 0).code(), AGAA_ERROR_OUT_OF_RANGE);
}

TEST_F(Queries, Capabilities) {
    const auto ideal = agaa::queryCapabilities();
    ASSERT_TRUE(ideal);
    uint32_t count = 0;
    ASSERT_EQ(agaaQueryCapabilities(nullptr, &count, nullptr), AGAA_OK);
    EXPECT_EQ(ideal->size(), count);
    EXPECT_TRUE(std::any_of(ideal->begin(), ideal->end(),
                            [](const AgaaCapability& c) { return c.technique == std::string_view("dcaa"); }));
    AgaaDeviceCaps caps = agaa::init<AgaaDeviceCaps>();
    EXPECT_TRUE(agaa::queryCapabilities(&caps));
    caps.structSize = 1;
    EXPECT_EQ(agaa::queryCapabilities(&caps).code(), AGAA_ERROR_STRUCT);
}

TEST_F(Queries, Memory) {
    const auto report = agaa::queryMemory(view, nullptr, log);
    const auto surfaces = agaa::querySurfaces(view, nullptr, log);
    ASSERT_TRUE(report && surfaces);
    uint64_t bytes = 0;
    bool hasDepth = false;
    for (const AgaaSurface& surface : *surfaces) {
        bytes += surface.isPerPixel ? surface.bytes : 0;
        hasDepth = hasDepth || agaa::text(surface.name) == "depth";
    }
    EXPECT_EQ(report->totalBytes, bytes);
    EXPECT_EQ(report->bytesPerPixel, double(bytes) / (640 * 360));
    EXPECT_TRUE(hasDepth);
    const auto target = agaa::queryTarget(view, nullptr, log);
    ASSERT_TRUE(target);
    EXPECT_EQ(target->width, 640 * target->scaleX);
    EXPECT_EQ(target->geometryPasses, 2u);
    EXPECT_TRUE(messages.empty());
}

TEST_F(Queries, Prices) {
    const auto prices = agaa::queryPrices(view, nullptr, log);
    ASSERT_TRUE(prices);
    EXPECT_GT(prices->size(), 20u);
    size_t count = 0;
    for (const AgaaPrice& price : agaa::queryPrices(view).value()) // a temporary that the loop keeps
        count += agaa::text(price.reason).empty() == (price.isPossible == 1);
    EXPECT_EQ(count, prices->size());
    EXPECT_EQ(prices->front().kind, uint32_t(AGAA_PRICE_VIEW));
    EXPECT_EQ(prices->front().totalBytes, int64_t(agaa::queryMemory(view)->totalBytes));
}

TEST_F(Queries, TextsEndBeforeTheirZero) {
    const auto plan = agaa::planToJson(view, nullptr, log);
    ASSERT_TRUE(plan);
    size_t size = 0;
    ASSERT_EQ(agaaPlanToJson(&view, nullptr, nullptr, &size, nullptr), AGAA_OK);
    std::string text(size, '?');
    ASSERT_EQ(agaaPlanToJson(&view, nullptr, nullptr, &size, text.data()), AGAA_OK);
    EXPECT_EQ(*plan, text.c_str());
    EXPECT_EQ(plan->size(), size - 1);
    EXPECT_NE(agaa::getCoverageGlsl(log)->find("agaa_"), std::string::npos);
    EXPECT_NE(agaa::getAggregateGlsl(view, nullptr, log)->find("AgaaAggregate agaaAggregate("), std::string::npos);
}

TEST_F(Queries, Errors) {
    config.flags = uint64_t(1) << 40;
    EXPECT_EQ(agaa::planToJson(view, nullptr, log).code(), AGAA_ERROR_OUT_OF_RANGE);
    ASSERT_EQ(messages.size(), 1u);
    EXPECT_EQ(messages[0].severity, AGAA_SEVERITY_ERROR);
    EXPECT_EQ(messages[0].code, AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_NE(messages[0].text.find("0x10000000000"), std::string::npos);
    EXPECT_EQ(agaa::queryMemory(view).code(), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(agaa::querySurfaces(view).code(), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(agaa::queryPrices(view).code(), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(agaa::queryTarget(view).code(), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(agaa::getAggregateGlsl(view).code(), AGAA_ERROR_OUT_OF_RANGE);
    view.config = nullptr;
    EXPECT_EQ(agaa::queryMemory(view).code(), AGAA_ERROR_INVALID_ARGUMENT);
}

TEST_F(Queries, Goals) {
    AgaaGoal goal = agaa::init<AgaaGoal>();
    goal.maxErrorShare = 0.5f;
    AgaaFrameStatistics statistics = agaa::init<AgaaFrameStatistics>();
    AgaaObservation observation = agaa::init<AgaaObservation>();
    EXPECT_EQ(agaa::observe(view, nullptr, log, statistics, observation), AGAA_OK);
    EXPECT_EQ(observation.technique, std::string_view("agaa"));
    const auto choice = agaa::chooseSettings(view, nullptr, log, goal, &observation);
    ASSERT_TRUE(choice);
    EXPECT_EQ(choice->hasChanged, 1u);
    EXPECT_FALSE(agaa::text(choice->reason).empty());
    const auto again = agaa::chooseSettings(view, nullptr, log, goal, nullptr, &*choice);
    ASSERT_TRUE(again);
    EXPECT_EQ(again->hasChanged, 0u);
    AgaaAggregation aggregation = agaa::init<AgaaAggregation>();
    AgaaMeasurement measurement = agaa::init<AgaaMeasurement>();
    agaa::chain(config, aggregation, measurement);
    EXPECT_EQ(agaa::applyChoice(*choice, config, aggregation, &measurement), AGAA_OK);
    EXPECT_EQ(config.technique, std::string_view(choice->technique));
    goal.maxErrorShare = -1;
    EXPECT_EQ(agaa::chooseSettings(view, nullptr, log, goal).code(), AGAA_ERROR_OUT_OF_RANGE);
}

// ---- creation without a device ------------------------------------------------------------------

TEST_F(Queries, RequirementsOfTheGraphicsApis) {
    const auto vk = agaa::vk::getRequirements();
    ASSERT_TRUE(vk);
    const agaa::ArrayView<const char*> features(vk->requiredFeatures, vk->requiredFeatureCount);
    EXPECT_FALSE(features.empty());
    const auto gl = agaa::gl::getRequirements();
    ASSERT_TRUE(gl);
    EXPECT_EQ(gl->majorVersion, 4u);
}

TEST_F(Queries, ContextsWithoutADevice) {
    AgaaContextDesc desc = agaa::init<AgaaContextDesc>();
    desc.log = log;
    EXPECT_EQ(agaa::vk::createContext(desc).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::createContext(desc).code(), AGAA_ERROR_INVALID_ARGUMENT);
    AgaaVkDeviceDesc vk = agaa::init<AgaaVkDeviceDesc>();
    AgaaGlDeviceDesc gl = agaa::init<AgaaGlDeviceDesc>();
    EXPECT_EQ(agaa::vk::createContext(agaa::chain(desc, vk)).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::createContext(agaa::chain(desc, gl)).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(messages.size(), 4u);
    EXPECT_EQ(agaa::vk::getDeviceCaps(nullptr, nullptr, nullptr, log).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::getDeviceCaps(nullptr, nullptr, log).code(), AGAA_ERROR_INVALID_ARGUMENT);
}

TEST_F(Queries, ContextsOfAnotherVersion) {
    const AgaaContextDesc desc = agaa::init<AgaaContextDesc>();
    for (const uint32_t minor : {0u, 99u}) {
        const uint32_t version = minor << 12;
        EXPECT_EQ(agaa::vk::createContext(desc, version).code(), AGAA_ERROR_VERSION);
        EXPECT_EQ(agaa::gl::createContext(desc, version).code(), AGAA_ERROR_VERSION);
    }
}

TEST_F(Queries, NullHandles) {
    EXPECT_EQ(agaa::vk::createView(nullptr, view).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::createView(nullptr, view).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::vk::getContextCaps(nullptr).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::getContextCaps(nullptr).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::getProgramCache(nullptr).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::getDrawPasses(nullptr).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::vk::getDrawPasses(nullptr).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::getDrawPasses(nullptr).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::getGlslResources(nullptr, 0).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::getSurface(nullptr, "depth").code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::vk::getSurface(nullptr, "depth").code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::getSurface(nullptr, "depth").code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::getFrameStatistics(nullptr, 1).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::validateFrame(nullptr, 1).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::getFactReport(nullptr, 1).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::getBreadcrumbs(nullptr).code(), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::resizeView(nullptr, 1, 1), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::prepareVariants(nullptr, {}), AGAA_ERROR_INVALID_ARGUMENT);
    const AgaaFrame frame = agaa::init<AgaaFrame>();
    EXPECT_EQ(agaa::vk::recordFrame(nullptr, frame, agaa::init<AgaaVkFrame>()), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaa::gl::recordFrame(nullptr, frame, agaa::init<AgaaGlFrame>()), AGAA_ERROR_INVALID_ARGUMENT);
}

} // namespace
