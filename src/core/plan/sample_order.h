// An order of the samples of a pixel in which the first few are far apart.
#pragma once

#include "core/plan/plan.h"
#include "core/plan/sample_patterns.h"

#include <cstdint>
#include <vector>

namespace agaa {

// Returns the positions of the plan's samples.
std::vector<SamplePosition> positionsOf(const Plan& plan);

// Returns indices of the positions. The first is nearest to the middle; each next one is farthest from all before it,
// on a pixel whose opposite edges are joined. The next nearest distances break ties, then the index. On grids of 2 by 2
// and 4 by 4 samples these are the orders of Bayer 1973.
std::vector<uint32_t> sampleOrder(const std::vector<SamplePosition>& positions);

} // namespace agaa
