// Named settings of "agaa".
#pragma once

#include "agaa_sdk.h"

#include <string_view>

namespace agaa {

// False where there is none of that name.
bool applyPreset(std::string_view name, AgaaConfig& config, AgaaAggregation& aggregation);

} // namespace agaa
