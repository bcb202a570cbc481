// A tangle of polished wires and coat hangers above a floor.
#include "scene/builtin/mesh_builder.h"
#include "scene/builtin/scenes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace harness::builtin {

namespace {

constexpr int kWires = 90;
constexpr int kHangers = 50;

struct Metal {
    const char* name;
    uint32_t color;
    float roughness;
};

constexpr std::array<Metal, 5> kMetals{{{"steel", 0xc6c4c0, 0.2f},
                                        {"brass", 0xe4c06a, 0.25f},
                                        {"copper", 0xf0a184, 0.22f},
                                        {"chrome", 0xdcdfe2, 0.15f},
                                        {"blue anodised", 0x5b7fc4, 0.35f}}};

// Returns a long wire that wanders through a dome around the middle.
MeshBuilder wire(Random& random) {
    std::array<glm::vec3, 9> knots;
    glm::vec3 p = 0.9f * unitVector(random);
    glm::vec3 heading = unitVector(random);
    for (glm::vec3& knot : knots) {
        // The wire turns slowly and back towards the middle, because hairpins would be narrower than the wire.
        heading = glm::normalize(heading + 0.9f * unitVector(random) - 0.5f * p);
        p += 0.5f * heading;
        knot = {p.x, 0.85f + 0.55f * p.y, p.z};
        knot.y = std::max(knot.y, 0.03f);
    }
    std::vector<glm::vec3> curve = smoothCurve(knots, 7);
    for (glm::vec3& point : curve) // a spline may go below its knots
        point.y = std::max(point.y, 0.015f);
    MeshBuilder mesh;
    mesh.tube(curve, random.in(0.0025f, 0.006f), 8, true);
    return mesh;
}

// Returns the outline of a coat hanger in the plane z = 0: shoulders, bar and hook.
MeshBuilder hanger(float width, float radius) {
    const float w = 0.5f * width;
    const std::array outline{
        glm::vec3(0, 0.02f, 0),           glm::vec3(w * 0.5f, -0.05f, 0),  glm::vec3(w * 0.95f, -0.12f, 0),
        glm::vec3(w, -0.15f, 0),          glm::vec3(w * 0.9f, -0.165f, 0), glm::vec3(0, -0.165f, 0),
        glm::vec3(-w * 0.9f, -0.165f, 0), glm::vec3(-w, -0.15f, 0),        glm::vec3(-w * 0.95f, -0.12f, 0),
        glm::vec3(-w * 0.5f, -0.05f, 0),  glm::vec3(0, 0.02f, 0)};
    MeshBuilder mesh;
    mesh.tube(smoothCurve(outline, 4), radius, 8, true);
    std::vector<glm::vec3> hook{{0, 0.01f, 0}, {0, 0.05f, 0}};
    for (int i = 0; i <= 12; ++i) {
        const float a = 4.2f * float(i) / 12 - 1.2f;
        hook.push_back({0.035f * std::cos(a) - 0.012f, 0.1f + 0.035f * std::sin(a), 0});
    }
    mesh.tube(hook, radius, 8, true);
    return mesh;
}

glm::dmat4 anyPose(const glm::dvec3& position, double scale, Random& random) {
    const glm::vec3 axis = unitVector(random);
    const double angle = random.in(0, 6.2832f);
    glm::dmat4 m = glm::translate(glm::dmat4(1), position);
    m = glm::rotate(m, angle, glm::dvec3(axis));
    return glm::scale(m, glm::dvec3(scale));
}

} // namespace

Scene makeMetal() {
    Scene scene;
    Random random(77);
    for (const Metal& metal : kMetals)
        addMaterial(scene, metal.name, metal.color, metal.roughness, 1);
    for (int i = 0; i < kWires; ++i)
        place(scene, addMesh(scene, wire(random), uint32_t(i) % uint32_t(kMetals.size())));
    std::array<uint32_t, kMetals.size()> hangers;
    for (uint32_t i = 0; i < hangers.size(); ++i)
        hangers[i] = addMesh(scene, hanger(0.36f + 0.03f * float(i), 0.0035f), i);
    for (uint32_t i = 0; i < kHangers; ++i) {
        const glm::vec3 away = unitVector(random);
        const float reach = random.in(0.2f, 1.0f);
        const double scale = random.in(1.2f, 2.0f);
        const glm::dvec3 position(reach * away.x, 0.95f + 0.55f * reach * away.y, reach * away.z);
        place(scene, hangers[i % hangers.size()], anyPose(position, scale, random));
    }
    MeshBuilder floor;
    floor.ground(6, 12, [](float, float) { return 0.0f; });
    addMaterial(scene, "floor", 0x6d6a66, 0.55f);
    place(scene, addMesh(scene, floor, lastMaterial(scene)));

    Camera camera;
    camera.name = "tangle";
    camera.eye = {2.3, 1.7, 3.1};
    camera.target = {0, 0.8, 0};
    camera.fovDegrees = 42;
    scene.cameras.push_back(camera);
    return scene;
}

} // namespace harness::builtin
