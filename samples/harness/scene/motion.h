// How a scene moves: its camera, its instances and its lights, frame by frame.
#pragma once

#include "scene/scene.h"

#include <functional>
#include <memory>
#include <string_view>

namespace harness {

// The functions depend on their arguments alone, because motion vectors come from two calls. Frames count from 0. A
// null function means that nothing of its kind moves.
struct Motion {
    std::function<Camera(uint32_t frame)> camera;
    // Returns a transform in world space, which follows the instance's own one.
    std::function<glm::dmat4(uint32_t instance, uint32_t frame)> placement;
    std::function<float(uint32_t light, uint32_t frame)> brightness; // times the light's colour
};

struct MotionName {
    std::string_view name;
    std::string_view shows; // one line
};
const std::vector<MotionName>& motionNames();

// The frame of the motion "light" in which the light is switched on.
constexpr uint32_t switchedOnFrame = 16;

// Makes a motion of the list for a scene, to which some motions add an object. Must be called before the scene is
// loaded. Returns null for other names.
//
// camera   Sees the first frame.
// height   Of the image, in pixels. Speeds are in pixels.
std::shared_ptr<const Motion> makeMotion(std::string_view name, Scene& scene, const Camera& camera, uint32_t height);

// Returns the camera of a frame of a walk to the side. Geometry at the distance of the first target moves by 1.3 pixels
// a frame in the image, and nearer geometry by more. height: of the image, in pixels.
Camera walkingCamera(Camera camera, uint32_t frame, uint32_t height);

} // namespace harness
