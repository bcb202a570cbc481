// Named settings of "agaa".
#pragma once

#include "agaa_sdk.h"

#include <vector>

namespace agaa {

std::vector<const char*> presetNames();
// Throws Error if there is no preset of that name, or if it needs a measurement that is null. The arguments are then
// unchanged.
void applyPreset(const char* name, AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement);
// Sets all members that presets set to the values of AGAA_…_INIT. The technique does not change.
void applyDefaults(AgaaConfig& config, AgaaAggregation& aggregation, AgaaMeasurement* measurement);
// Returns the preset whose settings these are, in static storage, or null.
const char* presetOf(const AgaaConfig& config, const AgaaAggregation& aggregation, const AgaaMeasurement& measurement);

} // namespace agaa
