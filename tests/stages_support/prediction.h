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

// What the ways that the other techniques and tiers take keep, too: views with c = 2 and this fetch function or none.
struct PayloadRow {
    const char* technique;
    uint32_t samples;
    uint32_t tier = AGAA_TIER_AUTO;
    uint64_t configFlags = 0;
    uint64_t measurementFlags = 0;
    uint64_t fetchFlags = 0;    // of the tier ids
    bool hasOwnPattern = false; // of coverage samples
};
const std::vector<PayloadRow>& payloadRows();
// Of functions that give triangles without area and black materials.
AgaaFetchFunction emptyFetch(uint64_t flags);

// Bytes of images whose size is not that of the view.
uint64_t tableBytes(const Prediction& prediction);

// Bytes of the per-pixel buffers. Each must be among those created, bytes to how many, and is taken out.
uint64_t takePixelBuffers(const Prediction& prediction, std::map<uint64_t, uint32_t>& created);

} // namespace agaa::test
