// Checks of single arguments that a host passes in. A failed check throws Error with one sentence.
#pragma once

#include "agaa_sdk.h"
#include "core/base/error.h"

#include <cmath>

namespace agaa {

inline void checkFinite(float value, const char* name) {
    if (!std::isfinite(value))
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is not finite.", name));
}

void checkRange(double value, double low, double high, const char* name);
// Accepts the sample counts of sums, coverage masks and targets: powers of two in [1, 32].
void checkSampleCount(uint32_t samples, const char* name);
void checkRange(uint64_t value, uint64_t low, uint64_t high, const char* name);
// Fails if `flags` has bits other than the known ones.
void checkFlags(uint64_t flags, uint64_t known, const char* name);
void checkReserved(uint64_t value, const char* name);

// Fails if the host was built for an incompatible version.
void checkHeaderVersion(uint32_t version);

} // namespace agaa
