// Functions that any thread may call: concurrent calls have the same results as single calls.
#include "cases.h"
#include "view_parts.h"

#include <atomic>
#include <thread>

namespace agaa::conformance {

namespace {

constexpr uint32_t threadCount = 8;

// Returns the results of a call as text. Two texts are equal if all results are equal.
using Answer = std::function<std::string(const Functions& sdk, uint32_t variant)>;

template <class T> std::string contentOf(const T& value) {
    return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

// Variants differ, so that calls that share memory by mistake give wrong results.
void testThreads(Test& test, const std::string& function, uint32_t repeats, const Answer& answer) {
    std::vector<std::string> expected;
    for (uint32_t i = 0; i < threadCount; ++i)
        expected.push_back(answer(test.sdk, i));
    std::atomic<uint32_t> waiting = threadCount, wrong = 0;
    const auto run = [&](uint32_t variant) {
        --waiting;
        while (waiting) // all threads begin together
            std::this_thread::yield();
        for (uint32_t i = 0; i < repeats; ++i)
            wrong += answer(test.sdk, variant) != expected[variant];
    };
    std::vector<std::thread> threads;
    for (uint32_t i = 0; i < threadCount; ++i)
        threads.emplace_back(run, i);
    for (std::thread& thread : threads)
        thread.join();
    test.check(wrong == 0, function + ": " + std::to_string(wrong) + " of " + std::to_string(threadCount * repeats) +
                               " calls from " + std::to_string(threadCount) +
                               " threads at once differ from the same calls of one thread.");
}

// Creates a variant of a view. Some variants are refused, so that threads report errors at the same time.
void vary(ViewParts& parts, uint32_t variant) {
    static const char* const techniques[] = {"agaa", "sbaa", "msaa", "agaa", "ssaa", "agaa", "agaa", "mlaa"};
    parts.config.technique = techniques[variant % 8];
    parts.desc.width = 100 + variant;
    parts.config.samples = variant == 6 ? 3 : 4;
    if (variant == 3)
        parts.chain(parts.fetch);
    if (variant == 5)
        parts.chain(parts.gbuffer);
}

std::string logText(const LogRecorder& log) {
    std::string text;
    for (const LogLine& line : log.lines)
        text += std::to_string(line.code) + line.text + '\n';
    return text;
}

std::string memory(const Functions& sdk, uint32_t variant) {
    ViewParts parts(sdk, nullptr);
    vary(parts, variant);
    LogRecorder log;
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    const AgaaSurface initial = AGAA_SURFACE_INIT;
    std::vector<AgaaSurface> surfaces(64, initial);
    uint32_t count = 64;
    const AgaaResult result =
        sdk.agaaQueryMemory(&parts.desc, &parts.caps, log.get(), &report, &count, surfaces.data());
    std::string text = std::to_string(result) + contentOf(report) + logText(log);
    for (const AgaaSurface& surface : surfaces)
        text += contentOf(surface);
    return text;
}

std::string target(const Functions& sdk, uint32_t variant) {
    ViewParts parts(sdk, nullptr);
    vary(parts, variant);
    LogRecorder log;
    AgaaTarget out = AGAA_TARGET_INIT;
    const AgaaResult result = sdk.agaaQueryTarget(&parts.desc, &parts.caps, log.get(), &out);
    return std::to_string(result) + contentOf(out) + logText(log);
}

std::string prices(const Functions& sdk, uint32_t variant) {
    ViewParts parts(sdk, nullptr);
    vary(parts, variant);
    LogRecorder log;
    const AgaaPrice initial = AGAA_PRICE_INIT;
    std::vector<AgaaPrice> list(128, initial);
    uint32_t count = 128;
    const AgaaResult result = sdk.agaaQueryPrices(&parts.desc, &parts.caps, log.get(), &count, list.data());
    std::string text = std::to_string(result) + std::to_string(count) + logText(log);
    for (const AgaaPrice& price : list)
        text += contentOf(price);
    return text;
}

std::string observation(const Functions& sdk, uint32_t variant) {
    ViewParts parts(sdk, nullptr);
    vary(parts, variant);
    LogRecorder log;
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    statistics.counters.visible = statistics.counters.shadingEvents = 1000 + variant;
    AgaaObservation out = AGAA_OBSERVATION_INIT;
    const AgaaResult result = sdk.agaaObserve(&parts.desc, &parts.caps, log.get(), &statistics, &out);
    return std::to_string(result) + contentOf(out) + logText(log);
}

std::string choice(const Functions& sdk, uint32_t variant) {
    ViewParts parts(sdk, nullptr);
    vary(parts, variant);
    LogRecorder log;
    AgaaGoal goal = AGAA_GOAL_INIT;
    goal.maxErrorShare = 1.0f / float(1 + variant * variant);
    AgaaChoice out = AGAA_CHOICE_INIT;
    const AgaaResult result =
        sdk.agaaChooseSettings(&parts.desc, &parts.caps, log.get(), &goal, nullptr, nullptr, &out);
    return std::to_string(result) + contentOf(out) + logText(log);
}

std::string appliedChoice(const Functions& sdk, uint32_t variant) {
    AgaaConfig config = AGAA_CONFIG_INIT;
    AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;
    AgaaChoice made = AGAA_CHOICE_INIT;
    made.technique = "ssaa";
    made.samples = 4 << (variant % 4); // no row has 16 samples
    const AgaaResult result = sdk.agaaApplyChoice(&made, &config, &aggregation, nullptr);
    return std::to_string(result) + contentOf(config) + contentOf(aggregation);
}

template <class Function> std::string viewText(const Functions& sdk, uint32_t variant, Function function) {
    ViewParts parts(sdk, nullptr);
    vary(parts, variant);
    LogRecorder log;
    size_t size = 1 << 20;
    std::string text(size, '#');
    const AgaaResult result = function(&parts.desc, &parts.caps, log.get(), &size, text.data());
    return std::to_string(result) + text.substr(0, result == AGAA_OK ? size : 0) + logText(log);
}

std::string coverage(const Functions& sdk, uint32_t variant) {
    LogRecorder log;
    size_t size = variant == 7 ? 1 : 1 << 20;
    std::string text(1 << 20, '#');
    const AgaaResult result = sdk.agaaGetCoverageGlsl(log.get(), &size, text.data());
    return std::to_string(result) + text.substr(0, result == AGAA_OK ? size : 0) + logText(log);
}

std::string capabilities(const Functions& sdk, uint32_t variant) {
    ViewParts parts(sdk, nullptr);
    parts.caps.sampleCounts = 0x3F >> (variant % 6);
    const AgaaCapability initial = AGAA_CAPABILITY_INIT;
    std::vector<AgaaCapability> rows(1024, initial);
    uint32_t count = 1024;
    std::string text = std::to_string(sdk.agaaQueryCapabilities(&parts.caps, &count, rows.data()));
    for (uint32_t i = 0; i < count && i < rows.size(); ++i)
        text += contentOf(rows[i]);
    return text;
}

std::string layout(const Functions& sdk, uint32_t variant) {
    static const char* const names[] = {"precise", "paper16", "mlaa"};
    AgaaLayout out = AGAA_LAYOUT_INIT;
    const AgaaResult result = sdk.agaaGetBuiltinLayout(names[variant % 3], &out);
    return std::to_string(result) + contentOf(out);
}

std::string preset(const Functions& sdk, uint32_t variant) {
    static const char* const names[] = {"paper", "fast", "balanced", "accurate", "mlaa"};
    AgaaConfig config = AGAA_CONFIG_INIT;
    AgaaAggregation aggregation = AGAA_AGGREGATION_INIT;
    AgaaMeasurement measurement = AGAA_MEASUREMENT_INIT;
    const AgaaResult result = sdk.agaaApplyPreset(names[variant % 5], &config, &aggregation, &measurement);
    config.technique = nullptr; // the pointer differs before and after the call
    return std::to_string(result) + contentOf(config) + contentOf(aggregation) + contentOf(measurement);
}

std::string names(const Functions& sdk, uint32_t variant) {
    const char* list[64] = {};
    uint32_t count = 64;
    std::string text = std::to_string(sdk.agaaGetNames(variant % 6, &count, list));
    for (const char* name : list)
        text += name ? name : "-";
    return text;
}

std::string jitter(const Functions& sdk, uint32_t variant) {
    std::string text;
    for (uint64_t i = 0; i < 64; ++i) {
        float position[2] = {7, 7};
        text += std::to_string(sdk.agaaGetJitter(i, variant * variant, position)) + contentOf(position);
    }
    return text;
}

std::string tierNames(const Functions& sdk, uint32_t variant) {
    std::string text;
    for (uint32_t i = 0; i < 32; ++i)
        text += sdk.agaaTierName(i + variant);
    return text;
}

std::string stageNames(const Functions& sdk, uint32_t variant) {
    std::string text;
    for (uint32_t i = 0; i < 8; ++i)
        text += sdk.agaaStageName(i + variant);
    return text;
}

std::string tierFromName(const Functions& sdk, uint32_t variant) {
    static const char* const list[] = {"ids", "gbuffer", "per_sample", "native", "auto", "mlaa", "layers", ""};
    uint32_t tier = 777;
    const AgaaResult result = sdk.agaaTierFromName(list[variant % 8], &tier);
    return std::to_string(result) + std::to_string(tier);
}

std::string vulkan(const Functions& sdk, uint32_t) {
    AgaaVkRequirements out = AGAA_VK_REQUIREMENTS_INIT;
    return std::to_string(sdk.agaaVkGetRequirements(&out)) + contentOf(out);
}

std::string openGl(const Functions& sdk, uint32_t) {
    AgaaGlRequirements out = AGAA_GL_REQUIREMENTS_INIT;
    return std::to_string(sdk.agaaGlGetRequirements(&out)) + contentOf(out);
}

std::string plan(const Functions& sdk, uint32_t variant) { return viewText(sdk, variant, sdk.agaaPlanToJson); }
std::string aggregateGlsl(const Functions& sdk, uint32_t variant) {
    return viewText(sdk, variant, sdk.agaaGetAggregateGlsl);
}

} // namespace

void addThreadCases(Suite& suite) {
    struct Row {
        const char* function;
        std::string (*answer)(const Functions&, uint32_t);
    };
    for (const Row& row :
         {Row{"agaaQueryMemory", memory}, Row{"agaaQueryTarget", target}, Row{"agaaQueryPrices", prices},
          Row{"agaaPlanToJson", plan}, Row{"agaaObserve", observation}, Row{"agaaChooseSettings", choice},
          Row{"agaaApplyChoice", appliedChoice}, Row{"agaaGetAggregateGlsl", aggregateGlsl},
          Row{"agaaGetCoverageGlsl", coverage}, Row{"agaaQueryCapabilities", capabilities},
          Row{"agaaGetBuiltinLayout", layout}, Row{"agaaApplyPreset", preset}, Row{"agaaGetNames", names},
          Row{"agaaGetJitter", jitter}, Row{"agaaTierName", tierNames}, Row{"agaaStageName", stageNames},
          Row{"agaaTierFromName", tierFromName}, Row{"agaaVkGetRequirements", vulkan},
          Row{"agaaGlGetRequirements", openGl}})
        suite.core(std::string(row.function) + "/threads",
                   [row](Test& test) { testThreads(test, row.function, 20, row.answer); });
}

} // namespace agaa::conformance
