// The errors that every function that takes a struct may return, and the log.
#include "cases.h"
#include "header_check.h"
#include "structs.h"
#include "wrong_views.h"

#include <limits>

namespace agaa::conformance {

namespace {

// Tests every pointer that a function without a device requires.
void testNullPointers(Test& test) {
    ViewParts parts(test.sdk, nullptr);
    const AgaaViewDesc* view = &parts.desc;
    LogRecorder log;
    const auto expect = [&](const char* function, const char* what, AgaaResult result) {
        expectRefused(test, result, AGAA_ERROR_INVALID_ARGUMENT, log, function, callWith(function, what));
    };
    size_t size = 0;
    uint32_t count = 0;
    AgaaTarget target = AGAA_TARGET_INIT;
    expect("agaaQueryMemory", "view = null",
           test.sdk.agaaQueryMemory(nullptr, nullptr, log.get(), nullptr, nullptr, nullptr));
    expect("agaaQueryPrices", "view = null", test.sdk.agaaQueryPrices(nullptr, nullptr, log.get(), &count, nullptr));
    expect("agaaQueryPrices", "count = null", test.sdk.agaaQueryPrices(view, nullptr, log.get(), nullptr, nullptr));
    AgaaGoal goal = AGAA_GOAL_INIT;
    AgaaChoice choice = AGAA_CHOICE_INIT;
    AgaaFrameStatistics statistics = AGAA_FRAME_STATISTICS_INIT;
    AgaaObservation observation = AGAA_OBSERVATION_INIT;
    expect("agaaObserve", "view = null", test.sdk.agaaObserve(nullptr, nullptr, log.get(), &statistics, &observation));
    expect("agaaChooseSettings", "view = null",
           test.sdk.agaaChooseSettings(nullptr, nullptr, log.get(), &goal, nullptr, nullptr, &choice));
    expect("agaaQueryTarget", "view = null", test.sdk.agaaQueryTarget(nullptr, nullptr, log.get(), &target));
    expect("agaaQueryTarget", "outTarget = null", test.sdk.agaaQueryTarget(view, nullptr, log.get(), nullptr));
    expect("agaaPlanToJson", "view = null", test.sdk.agaaPlanToJson(nullptr, nullptr, log.get(), &size, nullptr));
    expect("agaaPlanToJson", "size = null", test.sdk.agaaPlanToJson(view, nullptr, log.get(), nullptr, nullptr));
    expect("agaaGetAggregateGlsl", "view = null",
           test.sdk.agaaGetAggregateGlsl(nullptr, nullptr, log.get(), &size, nullptr));
    expect("agaaGetAggregateGlsl", "size = null",
           test.sdk.agaaGetAggregateGlsl(view, nullptr, log.get(), nullptr, nullptr));
    expect("agaaGetCoverageGlsl", "size = null", test.sdk.agaaGetCoverageGlsl(log.get(), nullptr, nullptr));
    const auto silent = [&](const char* what, AgaaResult result) {
        test.result(result, AGAA_ERROR_INVALID_ARGUMENT, what);
    };
    uint32_t tier = 0;
    silent("agaaGetBuiltinLayout with name = null", test.sdk.agaaGetBuiltinLayout(nullptr, &parts.layout));
    silent("agaaGetBuiltinLayout with outLayout = null", test.sdk.agaaGetBuiltinLayout("precise", nullptr));
    silent("agaaApplyPreset with config = null",
           test.sdk.agaaApplyPreset("fast", nullptr, &parts.aggregation, &parts.measurement));
    silent("agaaQueryCapabilities with count = null", test.sdk.agaaQueryCapabilities(nullptr, nullptr, nullptr));
    silent("agaaGetNames with count = null", test.sdk.agaaGetNames(AGAA_NAMES_TIERS, nullptr, nullptr));
    silent("agaaTierFromName with name = null", test.sdk.agaaTierFromName(nullptr, &tier));
    silent("agaaVkGetRequirements with null", test.sdk.agaaVkGetRequirements(nullptr));
    silent("agaaGlGetRequirements with null", test.sdk.agaaGlGetRequirements(nullptr));
}

// Passes the wrong views with this error to all queries.
void testWrongViewsOf(Test& test, AgaaResult error) {
    for (const WrongView& row : wrongViews())
        if (row.expected == error) {
            ViewParts parts(test.sdk, nullptr);
            row.corrupt(parts);
            expectViewRefused(test, parts, error, row.what, row.words);
        }
}

// A call that fails returns the code without a log, and with a log that has no callback.
void testNoCallback(Test& test) {
    AgaaLog log = AGAA_LOG_INIT;
    for (const WrongView& row : wrongViews()) {
        ViewParts parts(test.sdk, nullptr);
        row.corrupt(parts);
        for (const AgaaLog* pointer : {static_cast<const AgaaLog*>(nullptr), static_cast<const AgaaLog*>(&log)})
            test.result(test.sdk.agaaQueryMemory(parts.get(), &parts.caps, pointer, nullptr, nullptr, nullptr),
                        row.expected,
                        callWith("agaaQueryMemory", row.what) +
                            (pointer ? " and AgaaLog::callback = null" : " and log = null"));
    }
    ViewParts parts(test.sdk, nullptr);
    test.result(test.sdk.agaaQueryMemory(&parts.desc, nullptr, &log, nullptr, nullptr, nullptr), AGAA_OK,
                "agaaQueryMemory with AgaaLog::callback = null");
}

// Tests user, severity and text of an error in AgaaLogCallback.
void testMessages(Test& test) {
    for (const WrongView& row : wrongViews()) {
        ViewParts parts(test.sdk, nullptr);
        row.corrupt(parts);
        LogRecorder log;
        test.sdk.agaaQueryMemory(parts.get(), &parts.caps, log.get(), nullptr, nullptr, nullptr);
        for (const LogLine& line : log.errors())
            test.check(line.text.find('\n') == std::string::npos,
                       callWith("agaaQueryMemory", row.what) + ": the message has several lines: " + line.text);
        for (const LogLine& line : log.lines)
            test.check(line.severity == AGAA_SEVERITY_ERROR || line.code == AGAA_OK,
                       callWith("agaaQueryMemory", row.what) + ": a message that is no error has a code.");
    }
}

// ---- extreme but well-formed input ---------------------------------------------------------------

using Change = std::function<void(ViewParts&)>;

const std::vector<Change>& extremes() {
    static const std::vector<Change> changes = {
        [](ViewParts&) {},
        [](ViewParts& p) { p.desc.width = p.desc.height = 1; },
        [](ViewParts& p) { p.desc.width = p.desc.height = 1u << 20; },
        [](ViewParts& p) { p.desc.width = p.desc.height = 0xFFFFFFFF; },
        [](ViewParts& p) { p.desc.width = 0xFFFFFFFF; },
        [](ViewParts& p) { p.facts.maxLights = 4096; },
        [](ViewParts& p) { p.facts.maxLights = 0, p.facts.flags = 0; },
        [](ViewParts& p) { p.facts.shadowMapCount = 4, p.aggregation.litShadows = 15, p.aggregation.glossWeight = 16; },
        [](ViewParts& p) { p.facts.flags |= AGAA_FACT_CUSTOM_DEPTH; },
        [](ViewParts& p) { p.config.flags = 0x3F, p.measurement.flags = 0x1F; },
        [](ViewParts& p) { p.config.surfaceDistance = 1e6f, p.aggregation.aggregateThreshold = 1e6f; },
        [](ViewParts& p) { p.aggregation.characteristicLength = std::numeric_limits<float>::denorm_min(); },
        [](ViewParts& p) { p.coverage.fragmentsPerPixel = 256, p.coverage.maxBatches = 16; },
        [](ViewParts& p) { p.measurement.shadingCost = 64, p.config.shadowTaps = 32, p.config.ndf = AGAA_NDF_SGGX; },
        [](ViewParts& p) { p.caps.flags = 0, p.config.flags = 0; },
        [](ViewParts& p) {
            p.caps.flags =
                idealDeviceFlags | AGAA_DEVICE_NO_ALIASING | AGAA_DEVICE_SOFTWARE | AGAA_DEVICE_CONDITIONAL_RENDERING;
        },
        [](ViewParts& p) { p.caps.sampleCounts = 0x7F, p.caps.maxSharedBytes = 0xFFFFFFFF; },
        [](ViewParts& p) { p.caps.sampleCounts = 1, p.caps.maxImageSize = 0, p.caps.maxStorageRange = 0; },
        [](ViewParts& p) { p.caps.maxImageSize = 0xFFFFFFFF, p.caps.maxStorageRange = ~UINT64_C(0); },
        [](ViewParts& p) {
            p.desc.width = p.desc.height = p.caps.maxImageSize = 0xFFFFFFFF, p.caps.maxStorageRange = ~UINT64_C(0);
        },
        [](ViewParts& p) { p.chainAlone(p.gbuffer); },
        [](ViewParts& p) { p.chainAlone(p.fetch), p.fetch.flags = AGAA_FETCH_NOT_ALL_DRAWS; },
        [](ViewParts& p) { p.chainAlone(p.fetch), p.fetch.maxDraws = 0xFFFFFFFF, p.fetch.maxPrimitives = 1; },
    };
    return changes;
}

// Every call succeeds or reports an error of the input; none reports an internal error.
void testNoInternalError(Test& test) {
    std::vector<ViewQuery> queries = viewQueries();
    queries.push_back(aggregateGlslQuery);
    for (const char* technique : {"single", "fxaa", "smaa", "taa", "msaa", "ssaa", "visibility", "simple_complex",
                                  "sbaa", "agaa", "dcaa", "sgbc", "adaptive"})
        for (const uint32_t samples :
             hasCoverageSamples(technique) ? std::vector<uint32_t>{32, 64, 128} : std::vector<uint32_t>{1, 4, 32})
            for (const uint32_t aggregates : {1u, 4u})
                for (size_t i = 0; i < extremes().size(); ++i) {
                    ViewParts parts(test.sdk, nullptr);
                    parts.setTechnique(technique, samples);
                    parts.config.samples = samples;
                    parts.config.aggregates = aggregates;
                    extremes()[i](parts);
                    for (const ViewQuery& query : queries) {
                        LogRecorder log;
                        const AgaaResult result = query.call(test.sdk, &parts.desc, &parts.caps, log.get());
                        const std::string what =
                            callWith(query.name, std::string("\"") + technique + "\", n = " + std::to_string(samples) +
                                                     ", extreme " + std::to_string(i));
                        if (result == AGAA_OK)
                            continue;
                        const bool isNamed = result == AGAA_ERROR_UNSUPPORTED || result == AGAA_ERROR_TOO_LARGE;
                        if (!isNamed)
                            test.result(result, AGAA_OK, what);
                        expectRefused(test, result, result, log, query.name, what);
                    }
                }
}

} // namespace

void addConventionCases(Suite& suite) {
    suite.core("conventions/AGAA_ERROR_INVALID_ARGUMENT", [](Test& test) {
        testNullPointers(test);
        testWrongViewsOf(test, AGAA_ERROR_INVALID_ARGUMENT);
    });
    suite.core("conventions/AGAA_ERROR_STRUCT", [](Test& test) {
        testWrongViewsOf(test, AGAA_ERROR_STRUCT);
        for (const HeaderCase& c : coreHeaders())
            testSizes(test, c);
    });
    suite.core("conventions/AGAA_ERROR_VERSION", [](Test& test) {
        for (const HeaderCase& c : coreHeaders())
            testTail(test, c);
    });
    suite.core("conventions/AGAA_ERROR_UNKNOWN_STRUCT", [](Test& test) {
        testWrongViewsOf(test, AGAA_ERROR_UNKNOWN_STRUCT);
        for (const HeaderCase& c : coreHeaders())
            testChain(test, c);
    });
    suite.core("conventions/AGAA_ERROR_OUT_OF_RANGE",
               [](Test& test) { testWrongViewsOf(test, AGAA_ERROR_OUT_OF_RANGE); });
    suite.core("conventions/AGAA_ERROR_INTERNAL", testNoInternalError);
    suite.core("AgaaLog.callback/null", testNoCallback);
    suite.core("AgaaLog.callback/messages", testMessages);
}

} // namespace agaa::conformance
