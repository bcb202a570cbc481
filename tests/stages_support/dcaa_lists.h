// What `dcaa` leaves in memory, read back.
#pragma once

#include "view_settings.h"

#include "paper_merge.h"

#include <vector>

namespace agaa::test {

struct Kept {
    std::vector<std::vector<uint32_t>> lists;          // of each pixel, the ids of its fragments, last drawn first
    std::vector<std::vector<paper::Surface>> pixels;   // the surfaces of each
    AgaaCounters counters{};
};

// fragments, surfaces: the buffers; stride: words of a surface.
Kept keptOf(const ViewSettings& settings, const std::vector<uint32_t>& fragments, const std::vector<uint32_t>& surfaces,
            uint32_t stride, const AgaaCounters& counters);

// Rounds to what memory keeps.
void storeSurface(paper::Surface& surface);
paper::Rules rulesOf(const ViewSettings& settings, const paper::Surface& fragment);

// Masks are equal; numbers differ by steps of what memory keeps at most.
void expectSame(const std::vector<paper::Surface>& got, const std::vector<paper::Surface>& expected, size_t pixel);

} // namespace agaa::test
