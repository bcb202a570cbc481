#include "prediction.h"

#include <gtest/gtest.h>

#include <cstring>

namespace agaa::test {

Prediction predict(const AgaaViewDesc& desc, const AgaaDeviceCaps& caps) {
    Prediction p;
    uint32_t count = 0;
    EXPECT_EQ(agaaQueryMemory(&desc, &caps, nullptr, &p.report, &count, nullptr), 0);
    p.surfaces.resize(count);
    EXPECT_EQ(agaaQueryMemory(&desc, &caps, nullptr, &p.report, &count, p.surfaces.data()), 0);
    return p;
}

uint64_t takePixelBuffers(const Prediction& prediction, std::map<uint64_t, uint32_t>& created) {
    uint64_t bytes = 0;
    for (const AgaaSurface& surface : prediction.surfaces) {
        if (!surface.isPerPixel || std::strcmp(surface.format, "buffer") != 0)
            continue;
        uint32_t& count = created[surface.bytes];
        EXPECT_GT(count, 0u) << surface.name;
        count -= count > 0;
        bytes += surface.bytes;
    }
    return bytes;
}

} // namespace agaa::test
