// Figures of finished frames.
#include "vk/view.h"

#include "core/gpu_layout.h"

#include <cstring>

using namespace agaa;
using namespace agaa::vk;

static AgaaCounters readCounters(const CounterBuffer& source) {
    const auto wide = [](const uint32_t (&words)[2]) {
        return uint64_t(words[0]) | uint64_t(words[1]) << 32;
    };
    AgaaCounters out{};
    out.visible = wide(source.visible);
    out.once = wide(source.once);
    out.missed = wide(source.missed);
    out.multi = wide(source.multi);
    out.ties = wide(source.ties);
    out.sanitised = wide(source.sanitised);
    out.shadingEvents = wide(source.shadingEvents);
    out.shadowTaps = wide(source.shadowTaps);
    out.widenedLobes = wide(source.widenedLobes);
    out.shadedPixels = wide(source.shadedPixels);
    out.maxEventsPerPixel = source.maxEvents;
    return out;
}

AgaaResult AgaaView_T::statistics(uint64_t completedFrame, AgaaFrameStatistics& out) const {
    const FrameSlot* newest = nullptr;
    for (const FrameSlot& slot : slots)
        if (slot.complete && slot.frame <= completedFrame &&
            (!newest || slot.frame > newest->frame))
            newest = &slot;
    out.payloadBytes = resources->payloadBytes();
    out.driverBytes = resources->driverBytes();
    out.peakBytes = resources->peakBytes();
    out.geometryPasses = plan.geometryPasses();
    if (!newest)
        return AGAA_NOT_READY;
    const size_t slot = size_t(newest - slots.data());
    out.frameIndex = newest->frame;
    out.counters = {};
    for (ResourceId id = 0; id < plan.resources.size(); ++id)
        if (plan.resources[id].kind == ResourceKind::ReadbackBuffer) {
            CounterBuffer buffer;
            const auto& mapped = (*resources)[id].mapped;
            std::memcpy(&buffer, mapped[plan.resources[id].copies > 1 ? slot : 0], sizeof buffer);
            out.counters = readCounters(buffer);
        }
    std::vector<uint64_t> stamps(2 * passes.size());
    bool haveStamps = false;
    if (queries)
        haveStamps = context.vk.GetQueryPoolResults(
                         context.device, queries, uint32_t(slot * stamps.size()),
                         uint32_t(stamps.size()), stamps.size() * sizeof(uint64_t), stamps.data(),
                         sizeof(uint64_t), VK_QUERY_RESULT_64_BIT) == VK_SUCCESS;
    out.passCount = 0;
    for (size_t i = 0; i < passes.size() && out.passCount < AGAA_MAX_PASSES; ++i) {
        AgaaPassTime& time = out.passes[out.passCount++];
        time = {};
        std::strncpy(time.name, plan.passes[i].name.c_str(), sizeof time.name - 1);
        time.stage = plan.passes[i].stage;
        time.isTimed = haveStamps;
        // Subtracting under the mask survives a counter that wrapped (hard case 57).
        if (haveStamps)
            time.milliseconds = double((stamps[2 * i + 1] - stamps[2 * i]) & context.timestampMask) *
                                double(context.timestampPeriod) * 1e-6;
    }
    return AGAA_OK;
}
