// A ball of fur: tens of thousands of curved hairs, each narrower than a pixel.
#include "scene/builtin/mesh_builder.h"
#include "scene/builtin/scenes.h"

#include <array>
#include <cmath>

namespace harness::builtin {

namespace {

constexpr int kHairs = 34000;
constexpr float kRadius = 0.5f;

// Directions spread evenly over the sphere.
glm::vec3 fibonacciDirection(int i) {
    const float y = 1 - 2 * (float(i) + 0.5f) / kHairs;
    // The angle is in double precision, because it is large for late hairs.
    const double turn = std::fmod(double(i) * 2.39996322972865332, 6.28318530717958648);
    const float r = std::sqrt(1 - y * y);
    return {r * float(std::cos(turn)), y, r * float(std::sin(turn))};
}

// Returns the colour of the coat at a point: wavy bands.
size_t coatAt(const glm::vec3& n, Random& random) {
    const float band = std::sin(7 * n.y + 2.2f * std::sin(3 * n.x + 1) + 1.6f * std::cos(4 * n.z));
    if (band > 0.35f)
        return random.below(8) ? 0 : 3;
    if (band > -0.3f)
        return random.below(8) ? 1 : 3;
    return random.below(8) ? 2 : 1;
}

void addHair(MeshBuilder& mesh, const glm::vec3& n, Random& random) {
    // Returns a hair that is combed around a tilted axis, with gravity and some disorder.
    const glm::vec3 combed = glm::cross(glm::normalize(glm::vec3(0.3f, 1, 0.2f)), n);
    const glm::vec3 disorder = 0.45f * unitVector(random);
    const glm::vec3 sideways = 0.8f * combed + disorder + glm::vec3(0, -0.55f, 0);
    const glm::vec3 bend = sideways - n * glm::dot(n, sideways);
    const float length = random.in(0.14f, 0.24f);
    const float width = random.in(0.0011f, 0.0019f);
    std::array<glm::vec3, 5> points;
    std::array<float, 5> widths;
    for (size_t i = 0; i < points.size(); ++i) {
        const float s = float(i) / float(points.size() - 1);
        points[i] = kRadius * n + length * (s * (1 - 0.35f * s) * n + 0.75f * s * s * bend);
        widths[i] = width * (1 - s * s);
    }
    widths.back() = 0;
    const uint8_t tint = uint8_t(150 + random.below(106));
    mesh.color = {tint, tint, tint, 255};
    // The broad sides face all directions across the hair.
    const glm::vec3 across = glm::cross(n, unitVector(random));
    mesh.blade(points, widths, glm::length(across) > 0.1f ? across : bend + combed);
}

} // namespace

Scene makeFurball() {
    Scene scene;
    Random random(40);
    const std::array<uint32_t, 4> coats{0xf2e6d0, 0xc4762f, 0x5a3a28, 0x9aa0a8};
    std::array<MeshBuilder, 4> hairs;
    for (int i = 0; i < kHairs; ++i) {
        const glm::vec3 n = fibonacciDirection(i);
        MeshBuilder& mesh = hairs[coatAt(n, random)];
        addHair(mesh, n, random);
    }
    for (size_t i = 0; i < coats.size(); ++i) {
        addMaterial(scene, "hair", coats[i], 0.35f).doubleSided = true;
        place(scene, addMesh(scene, hairs[i], lastMaterial(scene)));
    }
    MeshBuilder skin;
    skin.sphere(glm::vec3(0), kRadius, 32, 64);
    addMaterial(scene, "skin", 0x7a5444, 0.7f);
    place(scene, addMesh(scene, skin, lastMaterial(scene)));
    MeshBuilder floor;
    floor.ground(3, 8, [](float, float) { return -0.68f; });
    addMaterial(scene, "floor", 0x8f959c, 0.6f);
    place(scene, addMesh(scene, floor, lastMaterial(scene)));

    Camera camera;
    camera.name = "front";
    camera.eye = {1.15, 0.75, 2.15};
    camera.target = {0, -0.02, 0};
    camera.fovDegrees = 36;
    scene.cameras.push_back(camera);
    return scene;
}

} // namespace harness::builtin
