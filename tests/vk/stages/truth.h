// What a frame must hold, sample by sample: which triangle each sample shows.
#pragma once

#include "stage_host.h"

namespace agaa::test {

inline constexpr uint32_t noTriangle = ~0u;

struct Truth {
    uint32_t width = 0, height = 0, samples = 0;
    std::vector<uint32_t> triangle; // (y width + x) samples + i

    uint32_t at(uint32_t x, uint32_t y, uint32_t i) const { return triangle[(size_t(y) * width + x) * samples + i]; }
};

// Renders primitive ids into a multisampled G-buffer of the same tier, by a technique that does not
// aggregate.
Truth visibleTriangles(StageContext& context, const ViewSettings& like, const std::vector<Triangle>& triangles);

} // namespace agaa::test
