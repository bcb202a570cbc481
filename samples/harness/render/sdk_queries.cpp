#include "render/sdk_queries.h"

#include <nlohmann/json.hpp>

namespace harness {

AgaaMemoryReport predictMemory(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, SdkLog& log) {
    const AgaaLog callback = log.log();
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    uint32_t surfaceCount = 0;
    log.check(agaaQueryMemory(&desc, &caps, &callback, &report, &surfaceCount, nullptr),
               "agaaQueryMemory");
    return report;
}

std::vector<std::pair<std::string, std::string>> plannedTiers(const AgaaViewDesc& desc,
                                                              const AgaaDeviceCaps& caps, SdkLog& log) {
    const AgaaLog callback = log.log();
    size_t size = 0;
    log.check(agaaPlanToJson(&desc, &caps, &callback, &size, nullptr), "agaaPlanToJson");
    std::vector<char> text(size);
    log.check(agaaPlanToJson(&desc, &caps, &callback, &size, text.data()), "agaaPlanToJson");
    std::vector<std::pair<std::string, std::string>> result;
    const auto plan = nlohmann::ordered_json::parse(text.data());
    for (const auto& [stage, tier] : plan.at("tiers").items())
        result.emplace_back(stage, tier.get<std::string>());
    return result;
}

} // namespace harness
