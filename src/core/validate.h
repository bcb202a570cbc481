// Checks of what a host passes in, before anything is recorded or changed.
#pragma once

#include "agaa_sdk.h"
#include "core/error.h"

#include <cmath>

namespace agaa {

struct Plan;

inline void checkFinite(float value, const char* name) {
    if (!std::isfinite(value))
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is not finite.", name));
}

void checkRange(double value, double low, double high, const char* name);
// The numbers of samples a pixel that sums, coverage masks and targets are made for.
void checkSampleCount(uint32_t samples, const char* name);
void checkRange(uint64_t value, uint64_t low, uint64_t high, const char* name);
// Bits of `flags` beyond the known ones.
void checkFlags(uint64_t flags, uint64_t known, const char* name);
void checkReserved(uint64_t value, const char* name);

// The version that a host was built for.
void checkHeaderVersion(uint32_t version);
// The frame's own facts, or those that the view announced. Throws where they are not valid or not within these.
AgaaSceneFacts factsOf(const AgaaFrame& frame, const Plan& plan);
// Against what the view was made for. The frame has its facts.
void checkFrame(const AgaaFrame& frame, const Plan& plan);
// Elements of the frame's arrays, which checkFrame() has accepted.
AgaaLight lightOf(const AgaaFrame& frame, uint32_t index);
AgaaShadow shadowOf(const AgaaFrame& frame, uint32_t index);

} // namespace agaa
