// Predictions of the SDK for a view on a device.
#pragma once

#include "render/renderer.h"
#include "render/sdk_log.h"

namespace harness {

AgaaMemoryReport predictMemory(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, SdkLog& log);
PlanSummary summarisePlan(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps, SdkLog& log);

} // namespace harness
