// Access to mapped buffers, and statistics of finished frames.
#include "core/base/timestamps.h"
#include "vk/view.h"

#include <cstring>

namespace agaa::vk {

MemoryUse View::memoryUse() const {
    return {resources->payloadBytes(), resources->driverBytes(), resources->peakBytes()};
}

std::byte* View::beginUpload(ResourceId buffer, uint32_t slot) { return resources->mapped(buffer, slot); }

// The memory is coherent.
void View::endUpload(ResourceId, uint32_t, uint64_t) {}

const std::byte* View::mappedBreadcrumbs() const { return resources->mapped(plan.breadcrumbs, 0); }

void View::readBuffer(ResourceId buffer, uint32_t slot, uint64_t offset, std::span<std::byte> data) const {
    std::memcpy(data.data(), resources->mapped(buffer, slot) + offset, data.size());
}

std::vector<double> View::readPassTimes(uint32_t slot) const {
    std::vector<double> times;
    std::vector<uint64_t> stamps(2 * steps.size());
    if (!queries)
        return times;
    const VkResult result = context.vk.GetQueryPoolResults(context.device, queries, uint32_t(slot * stamps.size()),
                                                           uint32_t(stamps.size()), stamps.size() * sizeof(uint64_t),
                                                           stamps.data(), sizeof(uint64_t), VK_QUERY_RESULT_64_BIT);
    if (result == VK_NOT_READY)
        return times;
    check(result, "vkGetQueryPoolResults");
    times.resize(passes.size());
    for (size_t i = 0; i < steps.size(); ++i)
        addStepTime(times[steps[i].pass],
                    double(elapsedTicks(stamps[2 * i], stamps[2 * i + 1], context.timestampBits)) *
                        double(context.timestampPeriod) * 1e-6);
    return times;
}

} // namespace agaa::vk
