// Named settings of "agaa".
#pragma once

#include "agaa_sdk.h"

#include <vector>

namespace agaa {

std::vector<const char*> presetNames();
// Throws Error where there is none of that name, or it needs a measurement that is null. All are then unchanged.
void applyPreset(const char* name, AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement);
// What presets set, as AGAA_…_INIT has it; the technique stays.
void applyDefaults(AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement);
// The preset that would change nothing; null where there is none. Static storage.
const char* presetOf(const AgaaConfig& config, const AgaaAggregation& aggregation, const AgaaMeasurement& measurement);

} // namespace agaa
