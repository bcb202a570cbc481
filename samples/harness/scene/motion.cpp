#include "scene/motion.h"

#include "scene/builtin/mesh_builder.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace harness {

namespace {

// Width of a pixel at the distance of the camera's target.
double pixelWidth(const Camera& camera, uint32_t height) {
    if (camera.height > 0)
        return camera.height / height;
    return 2 * std::tan(glm::radians(camera.fovDegrees) / 2) * glm::length(camera.target - camera.eye) / height;
}

// Returns the unit vector to the right in the image, or any horizontal one if the camera looks at nothing.
glm::dvec3 rightOf(const Camera& camera) {
    const glm::dvec3 forward = camera.target - camera.eye;
    glm::dvec3 right = glm::cross(forward, camera.up);
    if (glm::length(right) <= 1e-9 * glm::length(forward) * glm::length(camera.up)) // looks along up
        right = std::abs(forward.x) <= std::abs(forward.y) ? glm::dvec3(0, forward.z, -forward.y)
                                                           : glm::dvec3(-forward.z, 0, forward.x);
    const double length = glm::length(right);
    return length > 0 ? right / length : glm::dvec3(0);
}

// Shears each instance about the ground, as plants bend in gusts. The top of the scene sways by a fifteenth of its
// height to each side, in 40 frames, and neighbours sway after one another.
Motion wind(const Scene& scene) {
    const double ground = scene.boundsMin.y;
    const double height = std::max(scene.boundsMax.y - ground, 1e-9);
    std::vector<double> phases;
    for (const Instance& instance : scene.instances)
        phases.push_back((instance.transform[3].x + 0.6 * instance.transform[3].z) * 1.5 / height);
    Motion motion;
    motion.placement = [=](uint32_t instance, uint32_t frame) {
        const double lean = std::sin(glm::two_pi<double>() * frame / 40 + phases[instance]) / 15;
        glm::dmat4 shear(1);
        shear[1] = {lean, 1, 0.4 * lean, 0};
        shear[3] = {-lean * ground, 0, -0.4 * lean * ground, 1};
        return shear;
    };
    return motion;
}

// Turns the scene by a third of a degree a frame, as on a turntable.
Motion turn(const Camera& camera) {
    Motion motion;
    motion.placement = [=](uint32_t, uint32_t frame) {
        const glm::dmat4 there = glm::translate(glm::dmat4(1), camera.target);
        return glm::rotate(there, glm::radians(frame / 3.0), glm::dvec3(0, 1, 0)) *
               glm::translate(glm::dmat4(1), -camera.target);
    };
    return motion;
}

// Adds a box halfway to the target, which crosses the image by four pixels a frame.
Motion pass(Scene& scene, const Camera& camera, uint32_t height) {
    const glm::dvec3 middle = 0.5 * (camera.eye + camera.target), right = rightOf(camera);
    const double pixel = pixelWidth(camera, height) * (camera.height > 0 ? 1 : 0.5);
    const double half = 0.08 * height * pixel;
    builtin::MeshBuilder box;
    box.box(glm::vec3(-1), glm::vec3(1));
    builtin::addMaterial(scene, "passing box", 0xC87A5A, 0.5f);
    const uint32_t mesh = builtin::addMesh(scene, box, builtin::lastMaterial(scene));
    const uint32_t passing = uint32_t(scene.instances.size());
    builtin::place(scene, mesh, builtin::placement(middle, 0, half));
    updateBounds(scene);
    const double first = -0.6 * height * pixel;
    Motion motion;
    motion.placement = [=](uint32_t instance, uint32_t frame) {
        return instance == passing ? glm::translate(glm::dmat4(1), right * (first + 4.0 * frame * pixel))
                                   : glm::dmat4(1);
    };
    return motion;
}

Motion light() {
    Motion motion;
    motion.brightness = [](uint32_t light, uint32_t frame) {
        return light == 0 && frame < switchedOnFrame ? 0.0f : 1.0f;
    };
    return motion;
}

} // namespace

const std::vector<MotionName>& motionNames() {
    static const std::vector<MotionName> names = {
        {"still", "nothing moves"},
        {"walk", "the camera moves to the side"},
        {"wind", "the instances sway"},
        {"turn", "the scene turns"},
        {"pass", "a box passes in front of the scene"},
        {"light", "the first light is switched on"},
    };
    return names;
}

std::shared_ptr<const Motion> makeMotion(std::string_view name, Scene& scene, const Camera& camera, uint32_t height) {
    Motion motion;
    if (name == "walk")
        motion.camera = [=](uint32_t frame) { return walkingCamera(camera, frame, height); };
    else if (name == "wind")
        motion = wind(scene);
    else if (name == "turn")
        motion = turn(camera);
    else if (name == "pass")
        motion = pass(scene, camera, height);
    else if (name == "light")
        motion = light();
    else if (name != "still")
        return nullptr;
    return std::make_shared<const Motion>(std::move(motion));
}

Camera walkingCamera(Camera camera, uint32_t frame, uint32_t height) {
    const glm::dvec3 step = rightOf(camera) * (1.3 * pixelWidth(camera, height) * frame);
    camera.eye += step;
    camera.target += step;
    return camera;
}

} // namespace harness
