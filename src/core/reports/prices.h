// What effects, samples and aggregates of a view cost: differences of plans. It needs no device.
#pragma once

#include "core/plan/planner.h"

#include <vector>

namespace agaa {

// As agaaQueryPrices lists them. Throws Error where the view itself cannot be planned.
std::vector<AgaaPrice> listPrices(const ViewSettings& view, const AgaaDeviceCaps& caps, uint32_t framesInFlight);

} // namespace agaa
