// The pixels that the window shows, from the images A and B.
#pragma once

#include "image/image.h"
#include "viewer_state.h"

#include <vector>

namespace viewer {

// Returns the column from which B is shown in a split view.
uint32_t splitColumn(uint32_t width, double split);

// Returns the pixels of A, of B, of both with a line between them, or of their difference. The result is that of A
// while B is null or of another size.
std::vector<harness::Pixel> composed(const harness::Image& a, const harness::Image* b, const ViewerState& state);

} // namespace viewer
