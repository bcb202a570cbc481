// What frames of moving scenes must hold on any graphics API.
#pragma once

#include "render/renderer.h"

namespace harness::test {

// Expects images of the motion to show where surfaces were, within a stated part of a pixel, for moving cameras and
// moving instances.
void expectMotionIsShown(Renderer& renderer);
// Expects taa to follow moving instances by their motion vectors: errors, flicker, and errors of surfaces that became
// visible, beside those of single. Prints them.
void expectAccumulationFollowsMotion(Renderer& renderer);

} // namespace harness::test
