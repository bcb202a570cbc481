// Names of enum values as the ABI and the command line write them.
#pragma once

#include "agaa_sdk.h"

#include <string_view>

namespace agaa {

const char* tierName(uint32_t tier);
const char* stageName(uint32_t stage);
bool tierFromName(std::string_view name, uint32_t& tier);

} // namespace agaa
