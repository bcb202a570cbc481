// Small scenes whose images can be computed by hand: rectangles on whole pixels, seen by an orthographic camera that
// maps one unit to one pixel.
#pragma once

#include "agaa_sdk.h"

#include <vector>

namespace agaa::conformance {

struct Vertex {        // fetchShader() reads it as words
    float position[3]; // in shading space
    float normal[3];
    float diffuse[4]; // alpha is the fourth component
    float specular[3];
    float roughness; // alpha squared
    float emissive[3];
    uint32_t isMasked; // 1: drawn by the alpha-masked variant of the shader, with alphaCutoff 0.5
};

using Scene = std::vector<Vertex>; // three per triangle, drawn in order

struct Surface {
    float diffuse[4] = {0.5f, 0.5f, 0.5f, 1.0f};
    float normal[3] = {0, 0, 1};
    float specular[3] = {0, 0, 0};
    float roughness = 1;
    float emissive[3] = {0, 0, 0};
    bool isMasked = false;
};

// Adds the pixels [x0, x1) x [y0, y1) of a target of width x height, at a distance from the eye.
void addRectangle(Scene& scene, uint32_t width, uint32_t height, float x0, float y0, float x1, float y1, float distance,
                  const Surface& surface);

// Sets a column-major projection. Row 0 of the output is y0 = 0 of addRectangle. Depths in (0, farthest) are mapped to
// [0, 1], to [1, 0] with isReversed, or to [-1, 1] with fromMinusOne.
void setPixelCamera(AgaaFrame& frame, uint32_t width, uint32_t height, float farthest, bool isReversed,
                    bool fromMinusOne);

} // namespace agaa::conformance
