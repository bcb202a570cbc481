#include "scene/hard/parts.h"

#include <cmath>

namespace harness::hard {

using builtin::MeshBuilder;

Camera frontCamera() {
    Camera camera;
    camera.name = "front";
    camera.eye = {0, 0, 50};
    camera.fovDegrees = glm::degrees(2 * std::atan(18.0 / camera.eye.z));
    return camera;
}

uint32_t addLinear(Scene& scene, const char* name, const glm::vec3& color, float roughness, float metallic) {
    Material& material = builtin::addMaterial(scene, name, 0, roughness, metallic);
    material.baseColor = glm::vec4(color, 1);
    return builtin::lastMaterial(scene);
}

uint32_t addEmitter(Scene& scene, const char* name, const glm::vec3& emission) {
    const uint32_t material = addLinear(scene, name, glm::vec3(0), 1, 1); // a black metal has no diffuse light
    scene.materials[material].emissive = emission;
    return material;
}

void addRectangle(MeshBuilder& mesh, const glm::vec2& low, const glm::vec2& high, float z) {
    mesh.quad({low.x, low.y, z}, {high.x - low.x, 0, 0}, {0, high.y - low.y, 0});
}

void placeMesh(Scene& scene, const MeshBuilder& mesh, uint32_t material) {
    builtin::place(scene, builtin::addMesh(scene, mesh, material));
}

void addBackdrop(Scene& scene, float z, const glm::vec3& color) {
    MeshBuilder wall;
    const float scale = 1.2f * (50 - z) / 50;
    addRectangle(wall, {-32 * scale, -18 * scale}, {32 * scale, 18 * scale}, z);
    placeMesh(scene, wall, addLinear(scene, "backdrop", color, 0.9f));
}

Light& addSun(Scene& scene, const glm::dvec3& direction, const glm::vec3& color) {
    Light sun;
    sun.type = LightType::Directional;
    sun.direction = glm::normalize(direction);
    sun.color = color;
    scene.lights.push_back(sun);
    return scene.lights.back();
}

Light& addLamp(Scene& scene, const glm::dvec3& position, const glm::vec3& intensity, float radius) {
    Light lamp;
    lamp.position = position;
    lamp.color = intensity;
    lamp.radius = radius;
    scene.lights.push_back(lamp);
    return scene.lights.back();
}

} // namespace harness::hard
