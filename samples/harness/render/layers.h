// A layer over the anti-aliased image, which reads AGAA_RESOLVED_MEAN_DEPTH and COVERAGE: a transparent pane and
// particles around the point that the camera looks at.
#pragma once

#include "render/camera_matrices.h"

#include <array>
#include <string>

namespace harness {

constexpr uint32_t layerQuadCount = 65;

// std140, declared by shaders/layers.glsl.
struct LayerQuad {
    glm::vec4 centre, color, shape;
};
struct LayerConstants {
    glm::mat4 toClip;
    glm::vec4 right, up, depth;
    std::array<LayerQuad, layerQuadCount> quads; // from back to front
};

// rasterised: the projection as the graphics API rasterises it.
LayerConstants layerConstants(const CameraMatrices& camera, const glm::dmat4& rasterised);

// Returns the text of shaders/layers.glsl, then of a stage. head: the version and what the files need.
std::string layerText(const std::string& head, const char* stage);

// Returns the values that a renderer with a layer resolves: those of the host, then the two that the layer reads.
std::vector<AgaaResolvedValue> resolvedValues(const RenderSettings& settings);

} // namespace harness
