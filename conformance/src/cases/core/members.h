// Tests of single members of what describes a view: values that are accepted and values that are refused.
#pragma once

#include "view_parts.h"

#include <cmath>
#include <limits>

namespace agaa::conformance {

// Values are doubles, which hold every float and every uint32_t.
struct MemberRow {
    std::string promise; // AgaaConfig.samples/range
    const char* member;  // as the sentence names it, and the test's own sentences: AgaaConfig::samples
    std::function<void(ViewParts&, double)> set;
    std::vector<double> accepted, refused;
    std::function<void(ViewParts&)> prepare = nullptr; // where the member needs other parts
    // Values that a later library may accept; tested if the library has the version of these headers.
    std::vector<double> refusedToday = {};
    AgaaResult error = AGAA_ERROR_OUT_OF_RANGE;
};

// Flags: each documented bit alone is accepted, all others are refused. A later library may know some of them.
struct FlagRow {
    std::string promise;
    const char* member;
    std::function<void(ViewParts&, uint64_t)> set;
    uint64_t known;
    std::function<void(ViewParts&)> prepare = nullptr;
};

void addMember(Suite& suite, const MemberRow& row);
void addFlags(Suite& suite, const FlagRow& row);

// Next to a limit, as floats.
inline double above(float limit) { return std::nextafter(limit, std::numeric_limits<float>::infinity()); }
inline double below(float limit) { return std::nextafter(limit, -std::numeric_limits<float>::infinity()); }
// Refused by every float with a range.
std::vector<double> notNumbers(std::vector<double> others);
// Refused by every uint32_t with a range.
std::vector<double> largeNumbers(std::vector<double> others);

std::string numberText(double value);

} // namespace agaa::conformance
