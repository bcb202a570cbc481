// Bytes that passes read and write, for prices and for the plan's JSON.
#pragma once

#include "core/plan/plan.h"

#include <map>

namespace agaa {

// Returns the bytes of each per-pixel surface that a pass reads or writes, as AgaaPrice::trafficBytes counts them: each
// surface once and as a whole, and twice if the pass both reads and writes it. A fill of a part counts the part.
std::map<ResourceId, uint64_t> trafficOf(const Plan& plan, const Pass& pass);

} // namespace agaa
