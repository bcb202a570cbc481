#include "view_parts.h"

#include <nlohmann/json.hpp>

namespace agaa::conformance {

namespace {

constexpr const char* hostSample =
    "bool agaaHostSample(uvec2 pixel, uint i, inout float depth, inout AgaaMaterial m) { return false; }\n";
constexpr const char* hostShade = "vec3 agaaShade(AgaaSurface surface) { return surface.diffuse; }\n";
constexpr const char* hostShadow = "float agaaHostShadow(uint shadow, vec3 position) { return 1.0; }\n";

AgaaResult queryMemory(const Functions& sdk, const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log) {
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    uint32_t count = 0;
    return sdk.agaaQueryMemory(view, caps, log, &report, &count, nullptr);
}

AgaaResult queryTarget(const Functions& sdk, const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log) {
    AgaaTarget target = AGAA_TARGET_INIT;
    return sdk.agaaQueryTarget(view, caps, log, &target);
}

AgaaResult queryPrices(const Functions& sdk, const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log) {
    uint32_t count = 0;
    return sdk.agaaQueryPrices(view, caps, log, &count, nullptr);
}

AgaaResult queryPlan(const Functions& sdk, const AgaaViewDesc* view, const AgaaDeviceCaps* caps, const AgaaLog* log) {
    size_t size = 0;
    return sdk.agaaPlanToJson(view, caps, log, &size, nullptr);
}

AgaaResult queryAggregateGlsl(const Functions& sdk, const AgaaViewDesc* view, const AgaaDeviceCaps* caps,
                              const AgaaLog* log) {
    size_t size = 0;
    return sdk.agaaGetAggregateGlsl(view, caps, log, &size, nullptr);
}

AgaaDeviceCaps idealCaps() {
    AgaaDeviceCaps caps = AGAA_DEVICE_CAPS_INIT;
    caps.sampleCounts = 0x3F;
    caps.maxImageSize = 1u << 20;
    caps.maxStorageRange = UINT64_C(1) << 48;
    caps.maxSharedBytes = 49152;
    caps.subgroupSize = 32;
    caps.flags = idealDeviceFlags;
    return caps;
}

} // namespace

ViewParts::ViewParts(const Functions& sdk, const Device* device) : ViewDescription(device) {
    sdk.agaaInitLayout(&layout, sizeof layout);
    sdk.agaaGetBuiltinLayout("precise", &layout);
    sdk.agaaInitGBufferFunction(&gbuffer, sizeof gbuffer);
    sdk.agaaInitShadowFunction(&shadow, sizeof shadow);
    sdk.agaaInitShadingFunction(&shading, sizeof shading);
    sdk.agaaInitResolvedOutputs(&outputs, sizeof outputs);
    sdk.agaaInitAggregation(&spare, sizeof spare);
    gbuffer.glsl = hostSample;
    fetch = emptyFetch();
    shadow.glsl = hostShadow;
    shading.glsl = hostShade;
    shading.level = AGAA_SHADING_EVENT;
    shadow.shadows = 1;
    caps = idealCaps();
}

const std::vector<ViewQuery>& viewQueries() {
    static const std::vector<ViewQuery> queries = {{"agaaQueryMemory", queryMemory},
                                                   {"agaaQueryTarget", queryTarget},
                                                   {"agaaPlanToJson", queryPlan},
                                                   {"agaaQueryPrices", queryPrices}};
    return queries;
}

const ViewQuery aggregateGlslQuery = {"agaaGetAggregateGlsl", queryAggregateGlsl};

std::string callWith(const std::string& function, const std::string& what) { return function + " with " + what; }

void expectAccepted(Test& test, const ViewParts& parts, const std::string& what) {
    for (const ViewQuery& query : viewQueries()) {
        LogRecorder log;
        const AgaaResult result = query.call(test.sdk, parts.get(), &parts.caps, log.get());
        const std::vector<LogLine> errors = log.errors();
        test.result(result, AGAA_OK,
                    callWith(query.name, what) + (errors.empty() ? "" : " (\"" + errors[0].text + "\")"));
    }
}

void expectViewRefused(Test& test, const ViewParts& parts, AgaaResult expected, const std::string& what,
                       const std::string& words) {
    std::vector<ViewQuery> queries = viewQueries();
    queries.push_back(aggregateGlslQuery);
    for (const ViewQuery& query : queries) {
        LogRecorder log;
        expectRefused(test, query.call(test.sdk, parts.get(), &parts.caps, log.get()), expected, log, query.name,
                      callWith(query.name, what), words);
    }
}

std::string planText(Test& test, const ViewParts& parts) {
    size_t size = 0;
    test.requireOk(test.sdk.agaaPlanToJson(parts.get(), &parts.caps, nullptr, &size, nullptr),
                   "agaaPlanToJson with a valid view and text = null");
    std::string text(size, '#');
    test.requireOk(test.sdk.agaaPlanToJson(parts.get(), &parts.caps, nullptr, &size, text.data()),
                   "agaaPlanToJson with a valid view");
    text.resize(size - 1);
    return text;
}

std::string generationTierOf(Test& test, const ViewParts& parts) {
    const auto plan = nlohmann::json::parse(planText(test, parts));
    return plan.at("tiers").value("generation", "none");
}

std::vector<AgaaSurface> surfacesOf(Test& test, const ViewParts& parts, AgaaMemoryReport* outReport) {
    uint32_t count = 0;
    test.requireOk(test.sdk.agaaQueryMemory(parts.get(), &parts.caps, nullptr, nullptr, &count, nullptr),
                   "agaaQueryMemory with a valid view and surfaces = null");
    const AgaaSurface initial = AGAA_SURFACE_INIT;
    std::vector<AgaaSurface> surfaces(count, initial);
    test.requireOk(test.sdk.agaaQueryMemory(parts.get(), &parts.caps, nullptr, outReport, &count, surfaces.data()),
                   "agaaQueryMemory with a valid view");
    return surfaces;
}

} // namespace agaa::conformance
