// Prices of the effects, samples and aggregates of a view: differences between plans. They need no device.
#pragma once

#include "core/plan/planner.h"

#include <vector>

namespace agaa {

// Implements agaaQueryPrices. Throws Error if the view itself cannot be planned.
std::vector<AgaaPrice> listPrices(const ViewSettings& view, const AgaaDeviceCaps& caps, uint32_t framesInFlight);

} // namespace agaa
