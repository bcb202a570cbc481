// Named settings of "agaa".
#pragma once

#include "agaa_sdk.h"

#include <vector>

namespace agaa {

std::vector<const char*> presetNames();
// Throws Error where there is none of that name, or it needs a measurement that is null. All are then unchanged.
void applyPreset(const char* name, AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement);

} // namespace agaa
