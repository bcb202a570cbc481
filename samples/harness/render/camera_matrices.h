// The camera as the SDK and the vertex shader want it. Shading space: world axes, origin at the
// eye.
#pragma once

#include "render/renderer.h"

#include <glm/glm.hpp>

namespace harness {

// How a graphics API's clip space looks on the screen.
enum class ClipY { Up, Down };

struct CameraMatrices {
    glm::dvec3 eye{0}; // world, with the settings' offset
    glm::dvec3 forward{0, 0, -1};
    double targetDistance = 1;
    double nearPlane = 0;
    double farPlane = 0;      // of the standard depth range; the reversed one has none
    glm::dmat4 view{1};       // shading space to view space: a rotation
    glm::dmat4 projection{1}; // as the rasteriser uses it, jitter included
    glm::dmat4 viewProjection{1};
};

CameraMatrices cameraMatrices(const Scene& scene, const RenderSettings& settings, ClipY clipY);

// Object to shading space. In double up to here: the translation of an object far from the world's
// origin cancels against the eye's.
glm::dmat4 toShadingSpace(const glm::dmat4& objectToWorld, const glm::dvec3& worldOffset,
                          const glm::dvec3& eye);

} // namespace harness
