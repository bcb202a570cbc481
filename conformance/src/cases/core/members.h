// Tests of single members of the description of a view: accepted and refused values.
#pragma once

#include "view_parts.h"

#include <cmath>
#include <limits>

namespace agaa::conformance {

// Converts a value of a row to that of its member.
inline uint32_t whole(double value) { return uint32_t(value); }

// Values are doubles, which hold every float and every uint32_t.
struct MemberRow {
    std::string promise; // for example AgaaConfig.samples/range
    const char* member;  // name in the log and in the test's sentences, for example AgaaConfig::samples
    std::function<void(ViewParts&, double)> set;
    std::vector<double> accepted, refused;
    std::function<void(ViewParts&)> prepare = nullptr; // sets other members that the member needs
    // Values that a later library may accept; tested if the library has the version of these headers.
    std::vector<double> refusedToday = {};
    AgaaResult error = AGAA_ERROR_OUT_OF_RANGE;
};

// Tests flags: each documented bit alone is accepted, all other bits are refused. A later library may know some of
// them.
struct FlagRow {
    std::string promise;
    const char* member;
    std::function<void(ViewParts&, uint64_t)> set;
    uint64_t known;
    std::function<void(ViewParts&)> prepare = nullptr;
};

void addMember(Suite& suite, const MemberRow& row);
void addFlags(Suite& suite, const FlagRow& row);

// Return the float next to a limit.
inline double above(float limit) { return std::nextafter(limit, std::numeric_limits<float>::infinity()); }
inline double below(float limit) { return std::nextafter(limit, -std::numeric_limits<float>::infinity()); }
// Values that every float with a range refuses.
std::vector<double> notNumbers(std::vector<double> others);
// Values that every uint32_t with a range refuses.
std::vector<double> largeNumbers(std::vector<double> others);

std::string numberText(double value);

} // namespace agaa::conformance
