// Capacity of the fragment lists, from the fragments of a frame.
#pragma once

#include "render/renderer.h"

namespace harness {

// Returns AgaaDecoupledCoverage::fragmentsPerPixel for frames with an eighth more fragments than the given frame.
float capacityForFragments(uint64_t fragments, uint32_t width, uint32_t height);

// Draws one frame with a small capacity, which counts all fragments, and sets the capacity in the settings. It does
// nothing for techniques without lists.
void fitFragmentCapacity(Renderer& renderer, RenderSettings& settings);

} // namespace harness
