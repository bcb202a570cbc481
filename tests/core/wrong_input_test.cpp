// Misuse through the C ABI: an error code, one sentence in the log, nothing changed.
#include "agaa_vk.h"

#include "render/technique_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using harness::TechniqueConfig;

struct LogLine {
    AgaaResult code;
    std::string text;
};

void AGAA_CALL collect(void* user, uint32_t, AgaaResult code, const char* message) {
    static_cast<std::vector<LogLine>*>(user)->push_back({code, message});
}

struct Request {
    TechniqueConfig config;
    AgaaSceneFacts facts = AGAA_SCENE_FACTS_INIT;
    AgaaViewDesc view = AGAA_VIEW_DESC_INIT;
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    Request() {
        view.width = 64;
        view.height = 36;
        agaaGetBuiltinLayout("precise", &layout);
        config.layout = &layout;
    }
    AgaaResult run(std::vector<LogLine>& lines) {
        view.config = view.config == reinterpret_cast<AgaaConfig*>(1) ? nullptr : &config;
        view.facts = view.facts == reinterpret_cast<AgaaSceneFacts*>(1) ? nullptr : &facts;
        AgaaLog log = AGAA_LOG_INIT;
        log.callback = collect;
        log.user = &lines;
        return agaaQueryMemory(&view, nullptr, &log, &report, nullptr, nullptr);
    }
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
};

struct Row {
    const char* what;
    AgaaResult expected;
    std::function<void(Request&)> spoil;
};

const AgaaStructHeader unknownStruct = {77, sizeof(AgaaStructHeader), nullptr};
const AgaaStructHeader optionalStruct = {77 | AGAA_STRUCTURE_TYPE_OPTIONAL_BIT,
                                         sizeof(AgaaStructHeader), nullptr};

// A G-buffer of the host's, with positions for one sample and what lies behind them in memory.
const float onePosition[] = {0.5f, 0.5f, NAN, NAN};
AgaaGBufferFunction gbufferFunction() {
    AgaaGBufferFunction function = AGAA_GBUFFER_FUNCTION_INIT;
    function.glsl = "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return false; }";
    function.samplePositions = onePosition;
    return function;
}
const AgaaGBufferFunction ownGBuffer = gbufferFunction();

AgaaLayoutAttribute& emission(AgaaLayout& layout) {
    return *std::find_if(layout.attributes, layout.attributes + layout.attributeCount,
                         [](const AgaaLayoutAttribute& a) { return a.semantic == AGAA_SEMANTIC_EMISSIVE; });
}

const Row rows[] = {
    {"valid", AGAA_OK, [](Request&) {}},
    {"one position of a technique with one sample", AGAA_OK,
     [](Request& r) {
         r.config.technique = "single";
         r.view.pNext = &ownGBuffer;
     }},
    {"a G-buffer of the host's that is too large", AGAA_ERROR_TOO_LARGE,
     [](Request& r) {
         r.config.technique = "single";
         r.view.pNext = &ownGBuffer;
         r.view.width = 0xFFFFFFFF;
     }},
    {"optional struct in chain", AGAA_OK, [](Request& r) { r.config.pNext = &optionalStruct; }},
    {"unknown struct in chain", AGAA_ERROR_UNKNOWN_STRUCT,
     [](Request& r) { r.config.pNext = &unknownStruct; }},
    {"settings of a wrong size", AGAA_ERROR_STRUCT, [](Request& r) { r.config.aggregation.structSize = 8; }},
    {"settings twice", AGAA_ERROR_UNKNOWN_STRUCT,
     [](Request& r) {
         static AgaaAggregation more;
         more = r.config.aggregation;
         more.pNext = nullptr;
         r.config.aggregation.pNext = &more;
     }},
    {"settings of another technique", AGAA_OK, [](Request& r) { r.config.technique = "ssaa"; }},
    {"wrong settings of another technique", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) {
         r.config.technique = "ssaa";
         r.config.measurement.seeds = 9;
     }},
    {"no settings", AGAA_OK, [](Request& r) { r.config.pNext = nullptr; }},
    {"unknown struct in view", AGAA_ERROR_UNKNOWN_STRUCT,
     [](Request& r) { r.view.pNext = &unknownStruct; }},
    {"null config", AGAA_ERROR_INVALID_ARGUMENT,
     [](Request& r) { r.view.config = reinterpret_cast<AgaaConfig*>(1); }},
    {"null facts", AGAA_ERROR_INVALID_ARGUMENT,
     [](Request& r) { r.view.facts = reinterpret_cast<AgaaSceneFacts*>(1); }},
    {"wrong sType", AGAA_ERROR_STRUCT, [](Request& r) { r.config.sType = 1; }},
    {"wrong structSize", AGAA_ERROR_STRUCT, [](Request& r) { r.config.structSize -= 4; }},
    {"wrong view size", AGAA_ERROR_STRUCT, [](Request& r) { r.view.structSize = 0; }},
    {"null technique", AGAA_ERROR_INVALID_ARGUMENT,
     [](Request& r) { r.config.technique = nullptr; }},
    {"unknown technique", AGAA_ERROR_UNSUPPORTED, [](Request& r) { r.config.technique = "taa"; }},
    {"n = 0", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.samples = 0; }},
    {"n = 3", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.samples = 3; }},
    {"n = 48", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.samples = 48; }},
    {"n = 64 and nothing that fetches", AGAA_ERROR_UNSUPPORTED, [](Request& r) { r.config.samples = 64; }},
    {"c = 0", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregates = 0; }},
    {"S = 7", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.technique = "sbaa", r.config.aggregates = 7; }},
    {"cosine of 2", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.surfaceCosine = 2; }},
    {"negative distance", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.surfaceDistance = -1; }},
    {"material not a number", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.surfaceMaterial = NAN; }},
    {"gloss weight", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregation.glossWeight = 17; }},
    {"gloss weight that is none", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregation.glossWeight = NAN; }},
    {"gloss weight of another tier", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.config.aggregation.glossWeight = 0.5f;
         r.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
     }},
    {"lit shadows", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregation.litShadows = 16; }},
    {"lit shadows of another tier", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.config.aggregation.litShadows = 1;
         r.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
     }},
    {"lit shadows without materials at hand", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.config.aggregation.litShadows = 1;
         r.config.flags = AGAA_CONFIG_BUFFERED;
     }},
    {"ndf", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.ndf = AGAA_NDF_SGGX + 1; }},
    {"elliptic lobes of another tier", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.config.ndf = AGAA_NDF_LEAN;
         r.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
     }},
    {"elliptic lobes in memory", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.config.ndf = AGAA_NDF_SGGX;
         r.config.flags = AGAA_CONFIG_BUFFERED;
     }},
    {"debug view", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.measurement.debugView = 9; }},
    {"debug view of forward shading", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.config.technique = "msaa";
         r.config.measurement.debugView = AGAA_DEBUG_VIEW_EVENTS;
     }},
    {"debug view of aggregates that are not made", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.config.technique = "ssaa";
         r.config.measurement.debugView = AGAA_DEBUG_VIEW_CLUSTERS;
     }},
    {"debug view of primitives without ids", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) { r.config.measurement.debugView = AGAA_DEBUG_VIEW_PRIMITIVES; }},
    {"c = 5", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregates = 5; }},
    {"HardCase21 k = 0", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.aggregation.characteristicLengthPerDistance = 0; }},
    {"HardCase21 k = -1", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.aggregation.characteristicLength = -1; }},
    {"HardCase21 k = NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.aggregation.characteristicLength = NAN; }},
    {"HardCase21 k = inf", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.aggregation.characteristicLength = INFINITY; }},
    {"k the largest float", AGAA_OK,
     [](Request& r) { r.config.aggregation.characteristicLength = std::numeric_limits<float>::max(); }},
    {"cosine NaN", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.surfaceCosine = NAN; }},
    {"distance NaN", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.surfaceDistance = NAN; }},
    {"distance infinite", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.surfaceDistance = INFINITY; }},
    {"distance 2e6", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.surfaceDistance = 2e6f; }},
    {"material infinite", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.surfaceMaterial = INFINITY; }},
    {"t infinite", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregation.aggregateThreshold = INFINITY; }},
    {"gloss weight infinite", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregation.glossWeight = INFINITY; }},
    {"k per distance infinite", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.aggregation.characteristicLengthPerDistance = INFINITY; }},
    {"k per distance NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.aggregation.characteristicLengthPerDistance = NAN; }},
    {"HardCase21 k denormal", AGAA_OK,
     [](Request& r) {
         r.config.aggregation.characteristicLength = 1e-40f;
         r.config.aggregation.characteristicLengthPerDistance = 0;
     }},
    {"t = NaN", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregation.aggregateThreshold = NAN; }},
    {"t < 0", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.aggregation.aggregateThreshold = -1; }},
    {"brdf", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.brdf = 9; }},
    {"ndf", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.ndf = 9; }},
    {"seeds", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.measurement.seeds = 9; }},
    {"shadow taps", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.shadowTaps = 33; }},
    {"shading cost 0", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.measurement.shadingCost = 0; }},
    {"unknown flags", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.flags = UINT64_C(1) << 60; }},
    {"unknown visibility tier", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.visibilityTier = 99; }},
    {"unknown generation tier", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.config.generationTier = 6; }},
    {"unknown generation tier of a technique without one", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.config.technique = "ssaa", r.config.generationTier = 99; }},
    {"reserved tier", AGAA_ERROR_UNSUPPORTED, [](Request& r) { r.config.visibilityTier = AGAA_TIER_LAYERS; }},
    {"tier of another stage", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) { r.config.generationTier = AGAA_TIER_SCALED_TARGET; }},
    {"HardCase55 0x0", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.view.width = r.view.height = 0; }},
    {"HardCase55 0 x 36", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.view.width = 0; }},
    {"too large", AGAA_ERROR_TOO_LARGE, [](Request& r) { r.view.width = 0xFFFFFFFF; }},
    {"view flags", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.view.flags = 64; }},
    {"too many lights", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.facts.maxLights = 5000; }},
    {"too many shadow maps", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.facts.shadowMapCount = 5; }},
    {"unknown facts", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.facts.flags = 1 << 20; }},
    {"custom depth in a tier that tests depth first", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.facts.flags |= AGAA_FACT_CUSTOM_DEPTH;
         r.config.generationTier = AGAA_TIER_POST_DEPTH_ATOMICS;
     }},
    {"custom depth in a technique that draws twice", AGAA_ERROR_UNSUPPORTED,
     [](Request& r) {
         r.facts.flags |= AGAA_FACT_CUSTOM_DEPTH;
         r.config.technique = "msaa";
     }},
    {"layout that does not pack", AGAA_ERROR_LAYOUT,
     [](Request& r) { r.layout.attributes[0].sampleBits = 9; }},
    {"layout of specular without roughness", AGAA_ERROR_LAYOUT,
     [](Request& r) {
         AgaaLayoutAttribute* const end = r.layout.attributes + r.layout.attributeCount;
         r.layout.attributeCount = uint32_t(
             std::remove_if(r.layout.attributes, end,
                            [](const AgaaLayoutAttribute& a) { return a.semantic == AGAA_SEMANTIC_ROUGHNESS; }) -
             r.layout.attributes);
     }},
    {"layout of an infinite range", AGAA_ERROR_LAYOUT, [](Request& r) { emission(r.layout).range = INFINITY; }},
    {"layout of a range NaN", AGAA_ERROR_LAYOUT, [](Request& r) { emission(r.layout).range = NAN; }},
    {"layout with a reserved member", AGAA_ERROR_OUT_OF_RANGE, [](Request& r) { r.layout.reserved = 1; }},
    {"layout of one attribute", AGAA_ERROR_LAYOUT, [](Request& r) { r.layout.attributeCount = 1; }},
    {"layout of too many attributes", AGAA_ERROR_LAYOUT,
     [](Request& r) { r.layout.attributeCount = AGAA_MAX_LAYOUT_ATTRIBUTES + 1; }},
    {"layout of unknown encoding", AGAA_ERROR_LAYOUT, [](Request& r) { emission(r.layout).encoding = 9; }},
    {"position of a sample NaN", AGAA_ERROR_OUT_OF_RANGE,
     [](Request& r) { r.view.pNext = &ownGBuffer; }}, // of samples behind the first
    {"two ways of materials", AGAA_ERROR_INVALID_ARGUMENT,
     [](Request& r) {
         static AgaaGBufferFunction gbuffer;
         static AgaaFetchFunction fetch;
         gbuffer = ownGBuffer;
         fetch = AGAA_FETCH_FUNCTION_INIT;
         fetch.glsl = "";
         fetch.maxDraws = fetch.maxPrimitives = 1;
         r.config.technique = "single";
         gbuffer.pNext = &fetch;
         r.view.pNext = &gbuffer;
     }},
    {"layout of wrong type", AGAA_ERROR_STRUCT, [](Request& r) { r.layout.sType = 0; }},
};

TEST(WrongInput, EachGetsItsCodeAndOneSentence) {
    for (const Row& row : rows) {
        std::vector<LogLine> lines;
        Request request;
        row.spoil(request);
        EXPECT_EQ(request.run(lines), row.expected) << row.what;
        if (row.expected == AGAA_OK) {
            EXPECT_TRUE(lines.empty()) << row.what;
            continue;
        }
        EXPECT_EQ(request.report.totalBytes + request.report.peakBytes, 0u) << row.what;
        ASSERT_EQ(lines.size(), 1u) << row.what;
        EXPECT_EQ(lines[0].text.rfind("agaaQueryMemory: ", 0), 0u) << lines[0].text;
        EXPECT_EQ(lines[0].code, row.expected);
        EXPECT_EQ(lines[0].text.back(), '.') << lines[0].text;
        EXPECT_EQ(lines[0].text.find('\n'), std::string::npos);
    }
}

TEST(WrongInput, NullPointersAndShortArrays) {
    EXPECT_EQ(agaaGetBuiltinLayout(nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    AgaaLayout layout = AGAA_LAYOUT_INIT;
    EXPECT_EQ(agaaGetBuiltinLayout("nonesuch", &layout), AGAA_ERROR_LAYOUT);
    EXPECT_EQ(agaaGetNames(AGAA_NAMES_TECHNIQUES, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    uint32_t count = 0;
    ASSERT_EQ(agaaGetNames(AGAA_NAMES_TECHNIQUES, &count, nullptr), AGAA_OK);
    std::vector<const char*> names(count);
    count = 1;
    EXPECT_EQ(agaaGetNames(AGAA_NAMES_TECHNIQUES, &count, names.data()), AGAA_ERROR_BUFFER_TOO_SMALL);
    Request request;
    request.view.config = &request.config;
    request.view.facts = &request.facts;
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    caps.sampleCounts = 0xF;
    caps.maxImageSize = 16384;
    caps.maxStorageRange = 1 << 20;
    request.config.technique = "single";
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    EXPECT_EQ(agaaQueryMemory(&request.view, &caps, nullptr, &report, nullptr, nullptr), AGAA_OK);
    caps.reserved = 1; // of a later header
    EXPECT_EQ(agaaQueryMemory(&request.view, &caps, nullptr, &report, nullptr, nullptr), AGAA_ERROR_OUT_OF_RANGE);
    caps.reserved = 0;
    caps.flags = UINT64_C(1) << 40;
    EXPECT_EQ(agaaQueryMemory(&request.view, &caps, nullptr, &report, nullptr, nullptr), AGAA_ERROR_OUT_OF_RANGE);
    EXPECT_EQ(agaaQueryCapabilities(&caps, &count, nullptr), AGAA_ERROR_OUT_OF_RANGE);
    AgaaSurface surface = AGAA_SURFACE_INIT;
    EXPECT_EQ(agaaQueryMemory(&request.view, nullptr, nullptr, &report, nullptr, &surface), AGAA_ERROR_INVALID_ARGUMENT);
    AgaaTarget target = AGAA_TARGET_INIT;
    EXPECT_EQ(agaaQueryTarget(&request.view, nullptr, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    request.view.width = 16384;
    caps.flags = 0;
    caps.maxImageSize = 16383;
    EXPECT_EQ(agaaQueryTarget(&request.view, &caps, nullptr, &target), AGAA_ERROR_TOO_LARGE);
    EXPECT_EQ(target.width, 0u);
    caps.maxImageSize = 16384;
    EXPECT_EQ(agaaQueryTarget(&request.view, &caps, nullptr, &target), AGAA_OK);
    EXPECT_EQ(target.width, 16384u);
    AgaaContext context = nullptr;
    EXPECT_EQ(agaaVkCreateContext(AGAA_HEADER_VERSION, nullptr, &context),
              AGAA_ERROR_INVALID_ARGUMENT);
    AgaaContextDesc desc = AGAA_CONTEXT_DESC_INIT;
    EXPECT_EQ(agaaVkCreateContext(AGAA_HEADER_VERSION + (1u << 22), &desc, &context),
              AGAA_ERROR_VERSION);
    EXPECT_EQ(agaaVkCreateContext(AGAA_HEADER_VERSION, &desc, &context),
              AGAA_ERROR_INVALID_ARGUMENT);
    AgaaView view = nullptr;
    EXPECT_EQ(agaaVkCreateView(nullptr, nullptr, &view), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaVkRecordFrame(nullptr, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGetDrawPasses(nullptr, nullptr, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGetFrameStatistics(nullptr, 0, nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaPlanToJson(nullptr, nullptr, nullptr, nullptr, nullptr),
              AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaGetSurface(nullptr, "depth", nullptr), AGAA_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(agaaResizeView(nullptr, 1, 1), AGAA_ERROR_INVALID_ARGUMENT);
    agaaDestroyView(nullptr);
    EXPECT_EQ(agaaDestroyContext(nullptr), AGAA_OK);
}

// Two calls: how much there is, and all of it or nothing.
TEST(WrongInput, WhatFindsNoRoomIsNotWritten) {
    Request request;
    request.view.config = &request.config;
    request.view.facts = &request.facts;
    using Text = AgaaResult(AGAA_CALL*)(const AgaaViewDesc*, const AgaaDeviceCaps*, const AgaaLog*, size_t*, char*);
    for (const Text text : {agaaPlanToJson, agaaGetAggregateGlsl}) {
        size_t size = 0;
        ASSERT_EQ(text(&request.view, nullptr, nullptr, &size, nullptr), AGAA_OK);
        ASSERT_GT(size, 100u);
        const std::string untouched(size + 1, '#');
        std::string out = untouched;
        size_t least = size - 1;
        EXPECT_EQ(text(&request.view, nullptr, nullptr, &least, out.data()), AGAA_ERROR_BUFFER_TOO_SMALL);
        EXPECT_EQ(out, untouched);
        size_t more = size + 1;
        EXPECT_EQ(text(&request.view, nullptr, nullptr, &more, out.data()), AGAA_OK);
        EXPECT_EQ(more, size);
        EXPECT_EQ(out.find('\0'), size - 1);
        EXPECT_EQ(out[size], '#');
    }
    uint32_t count = 0;
    ASSERT_EQ(agaaQueryCapabilities(nullptr, &count, nullptr), AGAA_OK);
    ASSERT_GT(count, 1u);
    const auto isUntouched = [](const auto& list, const auto& initial) {
        return std::all_of(list.begin(), list.end(), [&](const auto& element) {
            return std::memcmp(&element, &initial, sizeof initial) == 0;
        });
    };
    const AgaaCapability noCapability = AGAA_CAPABILITY_INIT;
    const AgaaSurface noSurface = AGAA_SURFACE_INIT;
    std::vector<AgaaCapability> capabilities(count, noCapability);
    uint32_t less = count - 1;
    EXPECT_EQ(agaaQueryCapabilities(nullptr, &less, capabilities.data()), AGAA_ERROR_BUFFER_TOO_SMALL);
    EXPECT_EQ(less, count - 1);
    EXPECT_TRUE(isUntouched(capabilities, noCapability));
    ASSERT_EQ(agaaQueryMemory(&request.view, nullptr, nullptr, nullptr, &count, nullptr), AGAA_OK);
    ASSERT_GT(count, 1u);
    std::vector<AgaaSurface> surfaces(count, noSurface);
    less = count - 1;
    EXPECT_EQ(agaaQueryMemory(&request.view, nullptr, nullptr, &request.report, &less, surfaces.data()),
              AGAA_ERROR_BUFFER_TOO_SMALL);
    EXPECT_EQ(less, count - 1);
    EXPECT_TRUE(isUntouched(surfaces, noSurface));
    EXPECT_EQ(request.report.totalBytes, 0u);
    EXPECT_EQ(agaaQueryMemory(&request.view, nullptr, nullptr, &request.report, &count, surfaces.data()), AGAA_OK);
    EXPECT_FALSE(isUntouched(surfaces, noSurface));
    EXPECT_GT(request.report.totalBytes, 0u);
}

TEST(WrongInput, ResultsAndTiersHaveNames) {
    for (AgaaResult result = AGAA_ERROR_INTERNAL; result <= AGAA_NOT_READY; ++result) {
        EXPECT_EQ(std::string(agaaResultName(result)).rfind("AGAA_", 0), 0u) << result;
        EXPECT_STRNE(agaaResultString(result), "unknown result") << result;
    }
    EXPECT_STREQ(agaaResultName(AGAA_ERROR_LAYOUT), "AGAA_ERROR_LAYOUT");
    EXPECT_STREQ(agaaResultName(AGAA_NOT_READY + 1), "unknown result");
    EXPECT_STREQ(agaaResultString(-999), "unknown result");
    for (uint32_t tier : {AGAA_TIER_AUTO, AGAA_TIER_NATIVE, AGAA_TIER_SCALED_TARGET,
                          AGAA_TIER_POST_DEPTH_ATOMICS, AGAA_TIER_PER_SAMPLE, AGAA_TIER_GBUFFER}) {
        uint32_t back = 999;
        EXPECT_EQ(agaaTierFromName(agaaTierName(tier), &back), AGAA_OK);
        EXPECT_EQ(back, tier);
    }
}

} // namespace
