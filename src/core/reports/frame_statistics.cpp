#include "core/reports/frame_statistics.h"

#include "core/base/timestamps.h"

#include <cstring>

namespace agaa {

AgaaCounters countersOf(const CounterBuffer& source) {
    AgaaCounters out{};
    const auto wide = [&](Counter counter) {
        return uint64_t(source.counts[counter][0]) | uint64_t(source.counts[counter][1]) << 32;
    };
#define AGAA_COUNTER(index, name, member) out.member = wide(name);
#define AGAA_COUNTER_MAX(index, name, member) out.member = wide(name);
#define AGAA_COUNTER_FACT(index, name, member, fact)
#include "shaders/tables/counters.inc"
#undef AGAA_COUNTER
#undef AGAA_COUNTER_MAX
#undef AGAA_COUNTER_FACT
    return out;
}

AgaaResult frameStatistics(const ViewState& view, uint64_t completedFrame, AgaaFrameStatistics& out) {
    const Plan& plan = view.plan;
    const FrameSequence::Slot* newest = view.finished(completedFrame);
    const MemoryUse memory = view.memoryUse();
    out.payloadBytes = memory.payload;
    out.driverBytes = memory.driver;
    out.peakBytes = memory.peak;
    out.geometryPasses = plan.geometryPasses();
    const CompileFigures figures = view.variants.figures();
    out.variantCount = figures.variants;
    out.compileMilliseconds = figures.milliseconds;
    out.compiledPipelines = figures.programs;
    out.cachedPipelines = figures.cached;
    if (!newest)
        return AGAA_NOT_READY;
    out.timeSource = AGAA_TIME_NONE;
    const uint32_t slot = view.sequence.indexOf(*newest);
    out.variantFlags = view.variantIn(slot).facts.flags;
    out.variantShadowMaps = view.variantIn(slot).facts.shadowMapCount;
    out.frameIndex = newest->frame;
    out.counters = plan.view.config.flags & AGAA_CONFIG_COUNTERS ? countersOf(view.readCounters(slot)) : AgaaCounters{};
    const std::vector<double> times = view.readPassTimes(slot);
    if (!times.empty())
        out.timeSource = view.timeSource();
    out.passCount = uint32_t(plan.passes.size()); // at most AGAA_MAX_PASSES; the planner rejects more
    for (size_t i = 0; i < plan.passes.size(); ++i) {
        AgaaPassTime& time = out.passes[i];
        time = {};
        std::strncpy(time.name, plan.passes[i].name.c_str(), sizeof time.name - 1);
        time.stage = plan.passes[i].stage;
        time.isTimed = !times.empty() && isPassTime(times[i]);
        time.milliseconds = time.isTimed ? times[i] : 0;
    }
    return AGAA_OK;
}

} // namespace agaa
