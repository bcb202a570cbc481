// A field of grass behind a railing. The number of blades is a parameter, which shows how errors grow with the number
// of surfaces in a pixel.
#include "scene/builtin/mesh_builder.h"
#include "scene/builtin/scenes.h"

#include <algorithm>
#include <array>

namespace harness::builtin {

namespace {

void addBlade(MeshBuilder& mesh, Random& random) {
    const float x = random.in(-4, 4), z = random.in(-5, 2);
    const float height = random.in(0.5f, 1.3f), width = random.in(0.012f, 0.03f);
    const glm::vec3 lean{random.in(-0.35f, 0.35f), 0, random.in(-0.35f, 0.35f)};
    std::array<glm::vec3, 4> points;
    std::array<float, 4> widths;
    for (size_t i = 0; i < points.size(); ++i) {
        const float s = float(i) / 3;
        points[i] = glm::vec3(x, height * s, z) + s * s * lean;
        widths[i] = width * (1 - s);
    }
    const uint8_t tint = uint8_t(120 + random.below(136));
    mesh.color = {tint, uint8_t(std::min(255u, tint + random.below(60))), uint8_t(tint / 2), 255};
    mesh.blade(points, widths, {random.in(-1, 1), 0, random.in(-1, 1)});
}

void addRailing(MeshBuilder& mesh) {
    for (int i = 0; i <= 120; ++i) {
        const float x = -3 + 0.05f * float(i);
        mesh.cylinder({x, 0, 2.4f}, {x, 1, 2.4f}, 0.006f, 6);
    }
    for (int i = 0; i < 6; ++i) { // wires
        const float y = 0.15f + 0.16f * float(i);
        const std::array<glm::vec3, 2> ends = {glm::vec3(-3, y, 2.4f), glm::vec3(3, y + 0.1f, 2.4f)};
        mesh.tube(ends, 0.003f, 5, true);
    }
}

} // namespace

Scene makeBlades(uint32_t count) {
    Scene scene;
    Random random(77);
    MeshBuilder grass, railing, ground;
    for (uint32_t i = 0; i < count; ++i)
        addBlade(grass, random);
    addRailing(railing);
    ground.ground(6, 24, [](float, float) { return 0.0f; });
    if (count > 0) {
        addMaterial(scene, "grass", 0xffffff, 0.45f).doubleSided = true;
        place(scene, addMesh(scene, grass, lastMaterial(scene)));
    }
    addMaterial(scene, "railing", 0x30343a, 0.35f);
    place(scene, addMesh(scene, railing, lastMaterial(scene)));
    addMaterial(scene, "ground", 0x6b5a44, 0.9f);
    place(scene, addMesh(scene, ground, lastMaterial(scene)));

    Camera camera;
    camera.name = "front";
    camera.eye = {0.3, 1.5, 5.2};
    camera.target = {0, 0.55, 0};
    camera.fovDegrees = 50;
    scene.cameras.push_back(camera);
    return scene;
}

} // namespace harness::builtin
