// Figures of finished frames.
#include "vk/view.h"

#include <cstring>

namespace agaa::vk {

MemoryUse View::memoryUse() const {
    return {resources->payloadBytes(), resources->driverBytes(), resources->peakBytes()};
}

CounterBuffer View::readCounters(uint32_t slot) const {
    CounterBuffer counters{};
    for (ResourceId id = 0; id < plan.resources.size(); ++id)
        if (plan.resources[id].kind == ResourceKind::ReadbackBuffer)
            std::memcpy(&counters, (*resources)[id].mapped[plan.resources[id].copies > 1 ? slot : 0],
                        sizeof counters);
    return counters;
}

std::vector<double> View::readPassTimes(uint32_t slot) const {
    std::vector<double> times;
    std::vector<uint64_t> stamps(2 * passes.size());
    if (!queries ||
        context.vk.GetQueryPoolResults(context.device, queries, uint32_t(slot * stamps.size()),
                                       uint32_t(stamps.size()), stamps.size() * sizeof(uint64_t),
                                       stamps.data(), sizeof(uint64_t),
                                       VK_QUERY_RESULT_64_BIT) != VK_SUCCESS)
        return times;
    // Subtracting under the mask survives a counter that wrapped (hard case 57).
    for (size_t i = 0; i < passes.size(); ++i)
        times.push_back(double((stamps[2 * i + 1] - stamps[2 * i]) & context.timestampMask) *
                        double(context.timestampPeriod) * 1e-6);
    return times;
}

} // namespace agaa::vk
