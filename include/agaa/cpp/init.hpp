// The defaults of structs. Part of agaa.hpp.
// SPDX-License-Identifier: MIT
#ifndef AGAA_CPP_INIT_HPP
#define AGAA_CPP_INIT_HPP

#include "agaa_sdk.h"

namespace agaa {

// Returns a struct with the values of its macro AGAA_…_INIT: its type, its size and the defaults of all members.
// init<AgaaFrame>() also sets lightSize and shadowSize. Other types than those below do not compile.
template <class T> [[nodiscard]] constexpr T init() noexcept = delete;

#if defined(__GNUC__)
// The macros of C have casts of C and NULL.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wzero-as-null-pointer-constant"
#endif
// The version that the host is compiled with, as agaa::getVersion() returns that of the library.
inline constexpr uint32_t headerVersion = AGAA_HEADER_VERSION;

template <> constexpr AgaaLog init() noexcept { return AGAA_LOG_INIT; }
template <> constexpr AgaaContextDesc init() noexcept { return AGAA_CONTEXT_DESC_INIT; }
template <> constexpr AgaaLayoutAttribute init() noexcept { return AGAA_LAYOUT_ATTRIBUTE_INIT; }
template <> constexpr AgaaLayout init() noexcept { return AGAA_LAYOUT_INIT; }
template <> constexpr AgaaConfig init() noexcept { return AGAA_CONFIG_INIT; }
template <> constexpr AgaaAggregation init() noexcept { return AGAA_AGGREGATION_INIT; }
template <> constexpr AgaaDecoupledCoverage init() noexcept { return AGAA_DECOUPLED_COVERAGE_INIT; }
template <> constexpr AgaaAdaptiveSampling init() noexcept { return AGAA_ADAPTIVE_SAMPLING_INIT; }
template <> constexpr AgaaTemporal init() noexcept { return AGAA_TEMPORAL_INIT; }
template <> constexpr AgaaMeasurement init() noexcept { return AGAA_MEASUREMENT_INIT; }
template <> constexpr AgaaSceneFacts init() noexcept { return AGAA_SCENE_FACTS_INIT; }
template <> constexpr AgaaViewDesc init() noexcept { return AGAA_VIEW_DESC_INIT; }
template <> constexpr AgaaDrawPass init() noexcept { return AGAA_DRAW_PASS_INIT; }
template <> constexpr AgaaLight init() noexcept { return AGAA_LIGHT_INIT; }
template <> constexpr AgaaShadow init() noexcept { return AGAA_SHADOW_INIT; }
template <> constexpr AgaaFrame init() noexcept { return AGAA_FRAME_INIT; }
template <> constexpr AgaaTemporalFrame init() noexcept { return AGAA_TEMPORAL_FRAME_INIT; }
template <> constexpr AgaaGBufferFunction init() noexcept { return AGAA_GBUFFER_FUNCTION_INIT; }
template <> constexpr AgaaFetchFunction init() noexcept { return AGAA_FETCH_FUNCTION_INIT; }
template <> constexpr AgaaShadowFunction init() noexcept { return AGAA_SHADOW_FUNCTION_INIT; }
template <> constexpr AgaaShadingFunction init() noexcept { return AGAA_SHADING_FUNCTION_INIT; }
template <> constexpr AgaaResolvedOutputs init() noexcept { return AGAA_RESOLVED_OUTPUTS_INIT; }
template <> constexpr AgaaDeviceCaps init() noexcept { return AGAA_DEVICE_CAPS_INIT; }
template <> constexpr AgaaCapability init() noexcept { return AGAA_CAPABILITY_INIT; }
template <> constexpr AgaaSurface init() noexcept { return AGAA_SURFACE_INIT; }
template <> constexpr AgaaMemoryReport init() noexcept { return AGAA_MEMORY_REPORT_INIT; }
template <> constexpr AgaaTarget init() noexcept { return AGAA_TARGET_INIT; }
template <> constexpr AgaaPrice init() noexcept { return AGAA_PRICE_INIT; }
template <> constexpr AgaaFrameStatistics init() noexcept { return AGAA_FRAME_STATISTICS_INIT; }
template <> constexpr AgaaFrameValidation init() noexcept { return AGAA_FRAME_VALIDATION_INIT; }
template <> constexpr AgaaFactReport init() noexcept { return AGAA_FACT_REPORT_INIT; }
template <> constexpr AgaaBreadcrumbs init() noexcept { return AGAA_BREADCRUMBS_INIT; }
template <> constexpr AgaaMeasuredSettings init() noexcept { return AGAA_MEASURED_SETTINGS_INIT; }
template <> constexpr AgaaGoal init() noexcept { return AGAA_GOAL_INIT; }
template <> constexpr AgaaObservation init() noexcept { return AGAA_OBSERVATION_INIT; }
template <> constexpr AgaaChoice init() noexcept { return AGAA_CHOICE_INIT; }
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

} // namespace agaa

#endif // AGAA_CPP_INIT_HPP
