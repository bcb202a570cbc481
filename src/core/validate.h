// Checks of what a host passes in, before anything is recorded or changed.
#pragma once

#include "core/error.h"
#include "core/plan.h"

#include <cmath>
#include <vector>

namespace agaa {

// sType, structSize and the pNext chain. known: the types that may be chained to this struct, each once.
void checkHeader(const void* structure, uint32_t sType, size_t structSize, const char* name,
                 const std::vector<uint32_t>& known = {});
// Of a struct in a chain.
void checkStructSize(const void* structure, size_t structSize, const char* name);
// The struct of this type in a chain, or null.
const void* findChained(const void* structure, uint32_t sType);

// Reads a versioned struct of the host: null is an error, its header is checked.
template <typename Struct>
const Struct& checkStruct(const Struct* structure, uint32_t sType, const char* name) {
    checkHeader(structure, sType, sizeof(Struct), name);
    return *structure;
}

inline void checkFinite(float value, const char* name) {
    if (!std::isfinite(value))
        fail(AGAA_ERROR_OUT_OF_RANGE, format("%s is not finite.", name));
}

void checkRange(double value, double low, double high, const char* name);
// The numbers of samples a pixel that sums, coverage masks and targets are made for.
void checkSampleCount(uint32_t samples, const char* name);
void checkRange(uint64_t value, uint64_t low, uint64_t high, const char* name);

// The version that a host was built for.
void checkHeaderVersion(uint32_t version);
// Against what the view was made for.
void checkFrame(const AgaaFrame* frame, const Plan& plan);

} // namespace agaa
