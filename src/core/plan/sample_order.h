// In which order the samples of a pixel are taken, so that few of them lie far apart.
#pragma once

#include "core/plan/plan.h"
#include "core/plan/sample_patterns.h"

#include <cstdint>
#include <vector>

namespace agaa {

// Of the plan's samples, as many as it has.
std::vector<SamplePosition> positionsOf(const Plan& plan);

// Indices of the positions: the one nearest to the middle, then always the one farthest from all before it, on a pixel whose
// opposite edges meet. The next nearest distances decide between equals, then the index. On grids of 2 by 2 and 4 by 4 samples,
// these are the orders of Bayer 1973.
std::vector<uint32_t> sampleOrder(const std::vector<SamplePosition>& positions);

} // namespace agaa
