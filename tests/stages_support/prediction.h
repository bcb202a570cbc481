// What agaaQueryMemory predicts of a view, to be compared with what is created.
#pragma once

#include "agaa_sdk.h"

#include <map>
#include <vector>

namespace agaa::test {

struct Prediction {
    AgaaMemoryReport report = AGAA_MEMORY_REPORT_INIT;
    std::vector<AgaaSurface> surfaces;
};
Prediction predict(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps);

// Bytes of the per-pixel buffers. Each must be among those created, bytes to how many, and is taken out.
uint64_t takePixelBuffers(const Prediction& prediction, std::map<uint64_t, uint32_t>& created);

} // namespace agaa::test
