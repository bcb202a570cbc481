// Names of enum values as the ABI and the command line write them.
#pragma once

#include "agaa_sdk.h"

#include <string>
#include <string_view>
#include <vector>

namespace agaa {

// Compares names that hosts pass. '-' equals '_'.
bool isSameName(std::string_view a, std::string_view b);

// Returns a name of a host for a sentence: at most 64 bytes, with control characters as "\\x0A".
std::string printable(const char* name);

bool isTier(uint32_t tier);
const char* tierName(uint32_t tier);
const char* stageName(uint32_t stage);
std::vector<const char*> tierNames();
std::vector<const char*> stageNames();
bool tierFromName(std::string_view name, uint32_t& tier);

} // namespace agaa
