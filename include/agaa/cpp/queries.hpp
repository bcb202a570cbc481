// Functions without a handle: names, settings, predictions, shader text. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
//
// Threads   Any.
// caps      Null: an ideal device.
// log       May be null.
#ifndef AGAA_CPP_QUERIES_HPP
#define AGAA_CPP_QUERIES_HPP

#include "agaa/cpp/init.hpp"
#include "agaa/cpp/lists.hpp"
#include "agaa_sdk.h"

#include <array>

namespace agaa {

// ---- names and settings -------------------------------------------------------------------------

// kind   AgaaNameKind.
[[nodiscard]] inline Result<std::vector<std::string_view>> getNames(uint32_t kind) {
    const auto names = detail::list<uint32_t, const char*>(
        nullptr, [&](uint32_t* count, const char** elements) { return agaaGetNames(kind, count, elements); });
    if (!names)
        return Failure{names.code()};
    return std::vector<std::string_view>(names->begin(), names->end());
}

[[nodiscard]] inline std::string_view tierName(uint32_t tier) noexcept { return agaaTierName(tier); }
[[nodiscard]] inline std::string_view stageName(uint32_t stage) noexcept { return agaaStageName(stage); }

// The value is an AgaaTier.
[[nodiscard]] inline Result<uint32_t> tierFromName(const char* name) noexcept {
    return detail::filled(0u, [&](uint32_t* tier) { return agaaTierFromName(name, tier); });
}

[[nodiscard]] inline Result<AgaaLayout> getBuiltinLayout(const char* name) noexcept {
    return detail::filled(init<AgaaLayout>(), [&](AgaaLayout* layout) { return agaaGetBuiltinLayout(name, layout); });
}

// The structs keep their values on failure. Chain aggregation and measurement to config.
[[nodiscard]] inline AgaaResult applyPreset(const char* name, AgaaConfig& config, AgaaAggregation& aggregation,
                                            AgaaMeasurement* measurement = nullptr) noexcept {
    return agaaApplyPreset(name, &config, &aggregation, measurement);
}

// Returns x and y in pixels.
[[nodiscard]] inline Result<std::array<float, 2>> getJitter(uint64_t index, uint32_t count) noexcept {
    return detail::filled(std::array<float, 2>{},
                          [&](std::array<float, 2>* jitter) { return agaaGetJitter(index, count, jitter->data()); });
}

// ---- predictions --------------------------------------------------------------------------------

[[nodiscard]] inline Result<std::vector<AgaaCapability>> queryCapabilities(const AgaaDeviceCaps* caps = nullptr) {
    return detail::list<uint32_t>(init<AgaaCapability>(), [&](uint32_t* count, AgaaCapability* elements) {
        return agaaQueryCapabilities(caps, count, elements);
    });
}

[[nodiscard]] inline Result<AgaaMemoryReport>
queryMemory(const AgaaViewDesc& view, const AgaaDeviceCaps* caps = nullptr, const AgaaLog* log = nullptr) noexcept {
    return detail::filled(init<AgaaMemoryReport>(), [&](AgaaMemoryReport* report) {
        return agaaQueryMemory(&view, caps, log, report, nullptr, nullptr);
    });
}

// Returns the surfaces that agaaQueryMemory lists.
[[nodiscard]] inline Result<std::vector<AgaaSurface>>
querySurfaces(const AgaaViewDesc& view, const AgaaDeviceCaps* caps = nullptr, const AgaaLog* log = nullptr) {
    return detail::list<uint32_t>(init<AgaaSurface>(), [&](uint32_t* count, AgaaSurface* elements) {
        return agaaQueryMemory(&view, caps, log, nullptr, count, elements);
    });
}

[[nodiscard]] inline Result<AgaaTarget> queryTarget(const AgaaViewDesc& view, const AgaaDeviceCaps* caps = nullptr,
                                                    const AgaaLog* log = nullptr) noexcept {
    return detail::filled(init<AgaaTarget>(),
                          [&](AgaaTarget* target) { return agaaQueryTarget(&view, caps, log, target); });
}

[[nodiscard]] inline Result<std::vector<AgaaPrice>>
queryPrices(const AgaaViewDesc& view, const AgaaDeviceCaps* caps = nullptr, const AgaaLog* log = nullptr) {
    return detail::list<uint32_t>(init<AgaaPrice>(), [&](uint32_t* count, AgaaPrice* elements) {
        return agaaQueryPrices(&view, caps, log, count, elements);
    });
}

[[nodiscard]] inline Result<std::string> planToJson(const AgaaViewDesc& view, const AgaaDeviceCaps* caps = nullptr,
                                                    const AgaaLog* log = nullptr) {
    return detail::text([&](size_t* size, char* text) { return agaaPlanToJson(&view, caps, log, size, text); });
}

// ---- settings for a goal ------------------------------------------------------------------------

// The observation is read, too: it keeps what the statistics lack. It is unchanged on failure.
[[nodiscard]] inline AgaaResult observe(const AgaaViewDesc& view, const AgaaDeviceCaps* caps, const AgaaLog* log,
                                        const AgaaFrameStatistics& statistics, AgaaObservation& observation) noexcept {
    return agaaObserve(&view, caps, log, &statistics, &observation);
}

// observation   Null: no observation since the last call.
// current       The result of the last call. Null: none.
[[nodiscard]] inline Result<AgaaChoice> chooseSettings(const AgaaViewDesc& view, const AgaaDeviceCaps* caps,
                                                       const AgaaLog* log, const AgaaGoal& goal,
                                                       const AgaaObservation* observation = nullptr,
                                                       const AgaaChoice* current = nullptr) noexcept {
    return detail::filled(init<AgaaChoice>(), [&](AgaaChoice* choice) {
        return agaaChooseSettings(&view, caps, log, &goal, observation, current, choice);
    });
}

// The structs keep their values on failure. Chain aggregation and measurement to config.
[[nodiscard]] inline AgaaResult applyChoice(const AgaaChoice& choice, AgaaConfig& config, AgaaAggregation& aggregation,
                                            AgaaMeasurement* measurement = nullptr) noexcept {
    return agaaApplyChoice(&choice, &config, &aggregation, measurement);
}

// ---- shader text --------------------------------------------------------------------------------

[[nodiscard]] inline Result<std::string>
getAggregateGlsl(const AgaaViewDesc& view, const AgaaDeviceCaps* caps = nullptr, const AgaaLog* log = nullptr) {
    return detail::text([&](size_t* size, char* text) { return agaaGetAggregateGlsl(&view, caps, log, size, text); });
}

[[nodiscard]] inline Result<std::string> getCoverageGlsl(const AgaaLog* log = nullptr) {
    return detail::text([&](size_t* size, char* text) { return agaaGetCoverageGlsl(log, size, text); });
}

} // namespace agaa

#endif // AGAA_CPP_QUERIES_HPP
