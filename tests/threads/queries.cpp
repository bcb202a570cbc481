#include "queries.h"

#include "agaa_gl.h"
#include "agaa_sdk.h"
#include "agaa_vk.h"

#include <chrono>
#include <string>

namespace agaa::test {

namespace {

void AGAA_CALL onMessage(void* user, uint32_t, AgaaResult code, const char* message) {
    *static_cast<std::string*>(user) += std::to_string(code) + message;
}

// Returns the results of several functions as one text. Some calls fail, so that threads report errors.
std::string answers(uint32_t variant) {
    static const char* const techniques[] = {"agaa", "dcaa", "sgbc", "adaptive", "sbaa", "none", "msaa"};
    std::string text;
    AgaaLog log = AGAA_LOG_INIT;
    log.callback = onMessage;
    log.user = &text;
    AgaaConfig config = AGAA_CONFIG_INIT;
    config.technique = techniques[variant % 6];
    config.samples = variant % 6 == 1 ? 32 : 4;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaFetchFunction fetch = AGAA_FETCH_FUNCTION_INIT;
    fetch.glsl = "";
    fetch.glslExtensions = "#extension GL_EXT_nonuniform_qualifier : enable\n";
    fetch.maxDraws = fetch.maxPrimitives = 100;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    view.width = view.height = 64 + variant;
    view.config = &config;
    view.facts = &facts;
    if (variant % 2)
        view.pNext = &fetch;
    AgaaMemoryReport memory = AGAA_MEMORY_REPORT_INIT;
    text += std::to_string(agaaQueryMemory(&view, nullptr, &log, &memory, nullptr, nullptr)) +
            std::to_string(memory.totalBytes);
    std::string plan(1 << 16, ' ');
    size_t size = plan.size();
    text += std::to_string(agaaPlanToJson(&view, nullptr, &log, &size, plan.data())) + plan;
    AgaaGoal goal = AGAA_GOAL_INIT;
    goal.maxErrorShare = 0.5f;
    AgaaChoice choice = AGAA_CHOICE_INIT;
    text += std::to_string(agaaChooseSettings(&view, nullptr, &log, &goal, nullptr, nullptr, &choice)) + choice.reason;
    uint32_t prices = 0;
    text += std::to_string(agaaQueryPrices(&view, nullptr, &log, &prices, nullptr)) + std::to_string(prices);
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    text += std::to_string(agaaGetBuiltinLayout(variant % 2 ? "paper16" : "x", &layout));
    size = 0;
    text += std::to_string(agaaGetCoverageGlsl(&log, &size, nullptr)) + std::to_string(size);
    uint32_t capabilities = 0;
    text += std::to_string(agaaQueryCapabilities(nullptr, &capabilities, nullptr)) + std::to_string(capabilities);
    AgaaVkRequirements vulkan = AGAA_VK_REQUIREMENTS_INIT;
    AgaaGlRequirements openGl = AGAA_GL_REQUIREMENTS_INIT;
    return text + std::to_string(agaaVkGetRequirements(&vulkan)) + std::to_string(agaaGlGetRequirements(&openGl));
}

} // namespace

ConcurrentQueries::ConcurrentQueries() {
    for (uint32_t thread = 0; thread < 2; ++thread)
        threads_.emplace_back([this, thread] {
            std::vector<std::string> expected(6);
            for (uint32_t i = thread; !hasEnded_ || i < 12; ++i) {
                const std::string text = answers(i % 6);
                std::string& first = expected[i % 6];
                wrong_ += !first.empty() && first != text;
                first = text;
                ++calls_;
                std::this_thread::sleep_for(std::chrono::milliseconds(5)); // leaves the processor to the contexts
            }
        });
}

ConcurrentQueries::~ConcurrentQueries() {
    hasEnded_ = true;
    for (std::thread& thread : threads_)
        thread.join();
    EXPECT_GT(calls_, 12u);
    EXPECT_EQ(wrong_, 0u);
}

} // namespace agaa::test
