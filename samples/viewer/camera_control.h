// Cameras that follow the mouse and the keys: around a target, or through the scene.
#pragma once

#include "scene/scene.h"

#include <string>

namespace viewer {

// Returns the value of --camera for a perspective camera. Parsing it gives the same numbers.
std::string cameraText(const harness::Camera& camera);

// Turns the eye around the target. Angles are in radians. The camera never looks straight up or down.
harness::Camera orbited(harness::Camera camera, double yaw, double pitch);
// Turns the target around the eye.
harness::Camera turned(harness::Camera camera, double yaw, double pitch);
// Multiplies the distance between eye and target.
harness::Camera zoomed(harness::Camera camera, double factor);
// Moves eye and target. offset: to the right, up and forward, in world units.
harness::Camera moved(harness::Camera camera, const glm::dvec3& offset);

} // namespace viewer
