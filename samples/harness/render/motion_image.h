// How the surface that each pixel shows moved since the previous frame.
#pragma once

#include "render/renderer.h"

namespace harness {

struct MotionImage {
    uint32_t width = 0;
    uint32_t height = 0;
    // Per pixel, rows from top to bottom.
    std::vector<glm::vec2> toPrevious;   // displacement from this frame to the previous one, in pixels
    std::vector<float> distance;         // from the camera; infinity: no surface
    std::vector<float> previousDistance; // of the same point from the previous frame's camera
};

// Renders the motion between the frame before settings.firstFrame and that frame, at the centres of pixels. Frame 0 has
// no motion. Throws std::runtime_error for an orthographic camera. The settings' technique, lights and background are
// not used. Displacements of more than a quarter of the image are clamped.
MotionImage renderMotion(Renderer& renderer, RenderSettings settings);

} // namespace harness
