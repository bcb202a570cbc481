// Names of enum values as the ABI and the command line write them.
#pragma once

#include "agaa_sdk.h"

#include <string>
#include <string_view>
#include <vector>

namespace agaa {

// Returns whether words of GLSL may contain a byte: letters, digits and underscores, whatever the locale.
inline bool isWordByte(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// Compares names that hosts pass. '-' equals '_'.
bool isSameName(std::string_view a, std::string_view b);

// Returns text of a host or a driver for a sentence: UTF-8 of one line. Control characters and bytes that are not UTF-8
// become "\\x0A". Text after the first maxBytes is left out.
std::string printable(std::string_view text, size_t maxBytes = 64);

bool isTier(uint32_t tier);
const char* tierName(uint32_t tier);
const char* stageName(uint32_t stage);
std::vector<const char*> tierNames();
std::vector<const char*> stageNames();
bool tierFromName(std::string_view name, uint32_t& tier);

} // namespace agaa
