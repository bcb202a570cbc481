#include "render/sdk_queries.h"

#include <nlohmann/json.hpp>

namespace harness {

AgaaMemoryReport predictMemory(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, SdkLog& log) {
    const AgaaLog callback = log.log();
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    uint32_t surfaceCount = 0;
    log.check(agaaQueryMemory(&desc, &caps, &callback, &report, &surfaceCount, nullptr), "agaaQueryMemory");
    return report;
}

PlanSummary summarisePlan(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, SdkLog& log) {
    const AgaaLog callback = log.log();
    size_t size = 0;
    log.check(agaaPlanToJson(&desc, &caps, &callback, &size, nullptr), "agaaPlanToJson");
    std::vector<char> text(size);
    log.check(agaaPlanToJson(&desc, &caps, &callback, &size, text.data()), "agaaPlanToJson");
    PlanSummary summary;
    const auto plan = nlohmann::ordered_json::parse(text.data());
    summary.samples = plan.at("samples").get<uint32_t>();
    summary.aggregates = plan.at("aggregates").get<uint32_t>();
    for (const auto& [stage, tier] : plan.at("tiers").items())
        summary.tiers.emplace_back(stage, tier.get<std::string>());
    return summary;
}

} // namespace harness
