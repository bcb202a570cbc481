// The default camera and lights of a scene without its own.
#include "scene/random.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace harness {

namespace {

// Returns the diagonal of the bounds; 1 for an empty scene and a single point.
double sizeOf(const Scene& scene) {
    const double diagonal = glm::length(scene.boundsMax - scene.boundsMin);
    return diagonal > 0 ? diagonal : 1;
}

} // namespace

Camera defaultCamera(const Scene& scene) {
    const glm::dvec3 centre = 0.5 * (scene.boundsMin + scene.boundsMax);
    const double diagonal = sizeOf(scene);
    Camera camera;
    camera.name = "default";
    camera.fovDegrees = 50;
    camera.target = centre;
    // The bounding sphere fits the vertical field of view.
    const double distance = 0.5 * diagonal / std::sin(glm::radians(camera.fovDegrees) / 2);
    camera.eye = centre + distance * glm::normalize(glm::dvec3(0.6, 0.4, 0.75));
    return camera;
}

std::vector<Light> defaultLights(const Scene& scene) {
    return defaultLights(scene, scene.cameras.empty() ? defaultCamera(scene) : scene.cameras[0]);
}

namespace {

// Returns the extent of lights around the camera's target. A scene's bounds may extend far beyond its view.
double reachOf(const Scene& scene, const Camera& camera) {
    const double distance = glm::length(camera.target - camera.eye);
    return distance > 0 ? std::min(sizeOf(scene), 1.5 * distance) : sizeOf(scene);
}

// minRange and maxRange are shares of reachOf(). `irradiance` is the irradiance at half the range.
Light randomPointLight(const Scene& scene, const Camera& camera, Random& random, float minRange, float maxRange,
                       float irradiance) {
    const double reach = reachOf(scene, camera);
    Light light;
    light.type = LightType::Point;
    // Braces define the order of evaluation.
    const glm::dvec3 offset{random.in(-0.5f, 0.5f), random.in(-0.2f, 0.3f), random.in(-0.5f, 0.5f)};
    light.position = glm::clamp(camera.target + reach * offset, scene.boundsMin, scene.boundsMax);
    light.range = float(reach * random.in(minRange, maxRange));
    light.radius = 0.02f * light.range; // the light may lie at a wall and even inside of it
    const float intensity = irradiance * light.range * light.range * 0.25f;
    const float hue = random.unit() * 6.2832f;
    light.color = intensity * glm::vec3(1.0f + 0.5f * std::cos(hue), 1.0f + 0.5f * std::cos(hue - 2.1f),
                                        1.0f + 0.5f * std::cos(hue + 2.1f));
    return light;
}

} // namespace

std::vector<Light> defaultLights(const Scene& scene, const Camera& camera) {
    std::vector<Light> lights;
    Light sun;
    sun.type = LightType::Directional;
    sun.direction = glm::normalize(glm::dvec3(-0.45, -0.8, -0.35));
    sun.color = {2.6f, 2.45f, 2.2f};
    sun.castsShadow = true;
    lights.push_back(sun);
    Random random(17);
    for (int i = 0; i < 16; ++i)
        lights.push_back(randomPointLight(scene, camera, random, 0.25f, 0.4f, 0.45f));
    return lights;
}

std::vector<Light> smallLights(const Scene& scene, const Camera& camera, uint32_t count) {
    std::vector<Light> lights;
    Random random(29);
    for (uint32_t i = 0; i < count; ++i) {
        lights.push_back(randomPointLight(scene, camera, random, 0.03f, 0.08f, 0.3f));
        if (i % 4 == 3) {
            Light& spot = lights.back();
            spot.type = LightType::Spot;
            const glm::dvec3 down{random.in(-0.5f, 0.5f), -1.0, random.in(-0.5f, 0.5f)};
            spot.direction = glm::normalize(down);
        }
    }
    return lights;
}

} // namespace harness
