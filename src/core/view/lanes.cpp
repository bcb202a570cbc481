#include "core/view/lanes.h"

#include "core/base/error.h"

#include <algorithm>
#include <bit>

namespace agaa {

namespace {

// The largest number of bytes of shared memory of a pass besides the words of lanes, with the shortest list of
// primitives and without custom attributes (PlanBuilder::listLength()).
constexpr uint32_t otherBytes = 12544;

constexpr uint32_t lanesPerGroup = 64;

// The number of bytes of shared memory of a pass that merges fragments besides the surfaces: its counts.
constexpr uint32_t mergeBytes = 256;

// Returns why the lanes cannot run, or an empty text.
std::string obstacle(const AgaaDeviceCaps& caps, uint32_t samples, AgaaLanes lanes) {
    if (lanes == AGAA_LANES_SAMPLE_SUBGROUP) {
        if (caps.subgroupSize == 0)
            return "the device has no subgroup operations, or no full subgroups";
        if (caps.subgroupSize < std::bit_ceil(samples) || caps.subgroupSize > lanesPerGroup)
            return format("subgroups of the device have %u lanes, and %u to %u are needed", caps.subgroupSize,
                          std::bit_ceil(samples), lanesPerGroup);
    }
    const uint32_t needed = laneBytes(lanes, samples) + otherBytes;
    if (hasSampleLanes(lanes) && caps.maxSharedBytes < needed)
        return format("workgroups of the device have %u bytes of shared memory, and %u are needed", caps.maxSharedBytes,
                      needed);
    return {};
}

} // namespace

uint32_t laneBytes(AgaaLanes lanes, uint32_t samples) {
    if (!hasSampleLanes(lanes))
        return 0;
    const uint32_t groupingWords = lanes == AGAA_LANES_SAMPLE_SUBGROUP ? 9 : 12;
    return lanesPerGroup * uint32_t(sizeof(uint32_t)) * std::max(samples, groupingWords);
}

const char* lanesName(AgaaLanes lanes) {
    switch (lanes) {
    case AGAA_LANES_PIXEL:
        return "pixel";
    case AGAA_LANES_SAMPLE_SHARED:
        return "sample-shared";
    case AGAA_LANES_SAMPLE_SUBGROUP:
        return "sample-subgroup";
    case AGAA_LANES_AUTO:
    case AGAA_LANES_MAX_ENUM:
        break;
    }
    return "auto";
}

LaneChoice chooseLanes(const AgaaDeviceCaps& caps, uint32_t samples, uint32_t forced) {
    const auto description = [&](AgaaLanes lanes) -> std::string {
        if (lanes == AGAA_LANES_SAMPLE_SUBGROUP)
            return format("one per sample, in subgroups of %u", caps.subgroupSize);
        return lanes == AGAA_LANES_SAMPLE_SHARED ? "one per sample, with shared memory" : "one per pixel";
    };
    if (forced != AGAA_LANES_AUTO) {
        const auto lanes = AgaaLanes(forced);
        const std::string reason = obstacle(caps, samples, lanes);
        if (!reason.empty())
            return {AGAA_LANES_AUTO, reason + "."};
        return {lanes, description(lanes) + ", as AgaaMeasurement::lanes demands."};
    }
    if (samples == 1)
        return {AGAA_LANES_PIXEL, "one per pixel, which has one sample."};
    if (caps.flags & AGAA_DEVICE_SOFTWARE)
        return {AGAA_LANES_PIXEL, "one per pixel, because software devices access arrays of a lane fast."};
    std::string reasons;
    for (const AgaaLanes lanes : {AGAA_LANES_SAMPLE_SUBGROUP, AGAA_LANES_SAMPLE_SHARED}) {
        const std::string reason = obstacle(caps, samples, lanes);
        if (reason.empty())
            return {lanes, description(lanes) + (reasons.empty() ? "." : ", because " + reasons + ".")};
        reasons += (reasons.empty() ? "" : ", and ") + reason;
    }
    return {AGAA_LANES_PIXEL, "one per pixel, because " + reasons + "."};
}

SurfaceMemory chooseSurfaceMemory(const AgaaDeviceCaps& caps, uint32_t bytes, uint32_t forced) {
    const bool isForced = forced != AGAA_LANES_AUTO;
    if (isForced ? forced == AGAA_LANES_PIXEL : caps.flags & AGAA_DEVICE_SOFTWARE)
        return {.reason = std::string("one per pixel, with an array of surfaces, ") +
                          (isForced ? "as AgaaMeasurement::lanes demands."
                                    : "because software devices access arrays of a lane fast.")};
    const uint32_t needed = bytes + mergeBytes;
    if (caps.maxSharedBytes < needed) {
        const std::string reason = format("workgroups of the device have %u bytes of shared memory, and %u are needed",
                                          caps.maxSharedBytes, needed);
        return {.canRun = !isForced,
                .reason = (isForced ? "" : "one per pixel, with an array of surfaces, because ") + reason + "."};
    }
    return {.isShared = true,
            .reason = std::string("one per pixel, with surfaces in shared memory") +
                      (isForced ? ", as AgaaMeasurement::lanes demands." : ".")};
}

LaneChoice chooseListLanes(const AgaaDeviceCaps& caps, bool groupsFragments, uint32_t forced) {
    const char* const shared = groupsFragments ? "one per fragment that is grouped, with shared memory"
                                               : "one per pixel, with values of samples in shared memory";
    if (forced == AGAA_LANES_SAMPLE_SUBGROUP)
        return {AGAA_LANES_AUTO, "passes over lists of fragments have no variant with subgroup operations."};
    if (forced != AGAA_LANES_AUTO)
        return {AgaaLanes(forced), format("%s, as AgaaMeasurement::lanes demands.",
                                          forced == AGAA_LANES_PIXEL ? "one per pixel" : shared)};
    if (caps.flags & AGAA_DEVICE_SOFTWARE)
        return {AGAA_LANES_PIXEL, "one per pixel, because software devices access arrays of a lane fast."};
    return {AGAA_LANES_SAMPLE_SHARED, format("%s.", shared)};
}

} // namespace agaa
