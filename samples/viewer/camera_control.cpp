#include "camera_control.h"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace viewer {

using harness::Camera;

namespace {

constexpr double steepest = 1.5; // radians above and below the horizon

struct Direction {
    double yaw, pitch, length;
};

Direction directionOf(const glm::dvec3& v) {
    const double length = std::max(glm::length(v), 1e-9);
    return {std::atan2(v.x, v.z), std::asin(std::clamp(v.y / length, -1.0, 1.0)), length};
}

glm::dvec3 vectorOf(const Direction& d) {
    const double flat = std::cos(d.pitch) * d.length;
    return {flat * std::sin(d.yaw), std::sin(d.pitch) * d.length, flat * std::cos(d.yaw)};
}

// A camera of a file may have another vertical direction and may be orthographic. Moved cameras are those of --camera.
Camera upright(Camera camera) {
    camera.up = {0, 1, 0};
    camera.height = 0;
    return camera;
}

} // namespace

std::string cameraText(const Camera& camera) {
    std::string text;
    for (const double value : {camera.eye.x, camera.eye.y, camera.eye.z, camera.target.x, camera.target.y,
                               camera.target.z, camera.fovDegrees}) {
        char digits[32];
        const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
        text += (text.empty() ? "" : ",") + std::string(digits, end);
    }
    return text;
}

Camera orbited(Camera camera, double yaw, double pitch) {
    camera = upright(camera);
    Direction direction = directionOf(camera.eye - camera.target);
    direction.yaw += yaw;
    direction.pitch = std::clamp(direction.pitch + pitch, -steepest, steepest);
    camera.eye = camera.target + vectorOf(direction);
    return camera;
}

Camera turned(Camera camera, double yaw, double pitch) {
    camera = upright(camera);
    Direction direction = directionOf(camera.target - camera.eye);
    direction.yaw += yaw;
    direction.pitch = std::clamp(direction.pitch + pitch, -steepest, steepest);
    camera.target = camera.eye + vectorOf(direction);
    return camera;
}

Camera zoomed(Camera camera, double factor) {
    camera = upright(camera);
    camera.eye = camera.target + factor * (camera.eye - camera.target);
    return camera;
}

Camera moved(Camera camera, const glm::dvec3& offset) {
    camera = upright(camera);
    const Direction direction = directionOf(camera.target - camera.eye);
    const glm::dvec3 forward = vectorOf({direction.yaw, direction.pitch, 1});
    const glm::dvec3 right = {-std::cos(direction.yaw), 0, std::sin(direction.yaw)};
    const glm::dvec3 step = offset.x * right + offset.y * glm::cross(right, forward) + offset.z * forward;
    camera.eye += step;
    camera.target += step;
    return camera;
}

} // namespace viewer
