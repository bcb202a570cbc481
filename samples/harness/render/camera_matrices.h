// The camera for the SDK and the vertex shader. Shading space has the world's axes and its origin at the eye.
#pragma once

#include "render/renderer.h"

#include <glm/glm.hpp>

namespace harness {

// The clip space of a graphics API.
enum class ClipY { Up, Down };

struct CameraMatrices {
    glm::dvec3 eye{0}; // position in world space, with the settings' offset
    glm::dvec3 forward{0, 0, -1};
    double targetDistance = 1;
    double nearPlane = 0;     // 0 in an orthographic view
    double farPlane = 0;      // far plane of the standard depth range; the reversed range has none
    glm::dmat4 view{1};       // shading space to view space: a rotation
    glm::dmat4 projection{1}; // view space to clip space, with jitter
    glm::dmat4 viewProjection{1};
    glm::dvec2 jitter{0};          // by which the projection moves the image, in clip space
    glm::dvec4 viewer{0, 0, 0, 1}; // homogeneous position in shading space; w is 0 in an orthographic view
};

CameraMatrices cameraMatrices(const Scene& scene, const RenderSettings& settings, ClipY clipY);

// Returns the transform from object to shading space. It is computed in double precision, because the translation of an
// object far from the world's origin cancels against the eye's.
glm::dmat4 toShadingSpace(const glm::dmat4& objectToWorld, const glm::dvec3& worldOffset, const glm::dvec3& eye);

} // namespace harness
