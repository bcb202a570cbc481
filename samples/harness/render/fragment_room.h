// Room in lists of fragments, from what a frame asked for.
#pragma once

#include "render/renderer.h"

namespace harness {

// AgaaDecoupledCoverage::fragmentsPerPixel for frames that have an eighth more fragments than this one.
float roomForFragments(uint64_t fragments, uint32_t width, uint32_t height);

// Draws one frame with little room, which counts all fragments, and sets the room in settings. Without lists nothing
// happens.
void fitFragmentRoom(Renderer& renderer, RenderSettings& settings);

} // namespace harness
