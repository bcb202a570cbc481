// Dark, bright and empty images, and a picture for images of extreme sizes.
#include "scene/hard/parts.h"

#include <glm/gtc/matrix_transform.hpp>

#include <numbers>

namespace harness::hard {

using builtin::MeshBuilder;

Scene makeDarkRamp() {
    Scene scene;
    for (int i = 0; i < 16; ++i) {
        MeshBuilder mesh;
        const float left = -32 + 4 * float(i);
        addRectangle(mesh, {left, 0}, {left + 4, 18}, 0);
        for (int strip = -1; strip < 18; ++strip) // many fragments of one colour
            mesh.quad({left, -18 + float(strip), 0}, {4, 0.3f, 0}, {0, 1, 0});
        placeMesh(scene, mesh, addLinear(scene, "bar", glm::vec3(float(i + 1) / 16 / 255), 1));
    }
    addSun(scene, {0, 0, -1}, glm::vec3(float(std::numbers::pi))); // radiance is albedo
    scene.cameras.push_back(frontCamera());
    return scene;
}

namespace {

// Adds slanted bars with these emissions, three of each.
Scene glowingBars(std::initializer_list<glm::vec3> emissions) {
    Scene scene;
    const glm::dmat4 slant = glm::rotate(glm::dmat4(1), 0.12, glm::dvec3(0, 0, 1));
    const int count = int(emissions.size());
    int kind = 0;
    for (const glm::vec3& emission : emissions) {
        MeshBuilder mesh;
        for (int i = 0; i < 3; ++i) {
            const float spacing = 60.0f / float(3 * count);
            const float left = -30 + spacing * float(i * count + kind), width = 0.6f * spacing / float(i * i + 1);
            addRectangle(mesh, {left, -14}, {left + width, 14}, 0);
        }
        const uint32_t material = addEmitter(scene, "bars", emission);
        builtin::place(scene, builtin::addMesh(scene, mesh, material), slant);
        ++kind;
    }
    addSun(scene, {0, 0, -1}, glm::vec3(0));
    scene.cameras.push_back(frontCamera());
    return scene;
}

} // namespace

Scene makeEmission() { return glowingBars({glm::vec3(65504), glm::vec3(1e6f, 3, 0), glm::vec3(16, 65504, 1)}); }
Scene makeHdrEdges() { return glowingBars({glm::vec3(1), glm::vec3(10), glm::vec3(100)}); }

Scene makeStripes() {
    Scene scene;
    MeshBuilder mesh;
    for (int i = -40; i < 40; ++i) {
        mesh.color = glm::u8vec4(i % 2 ? 220 : 60, i % 3 ? 80 : 200, i % 5 ? 140 : 40, 255);
        mesh.quad({2 * float(i), -60, 0}, {2, 0, 0.3f * float(i % 3)}, {15, 120, 0});
    }
    placeMesh(scene, mesh, addLinear(scene, "stripes", glm::vec3(0.9f), 0.5f));
    addSun(scene, {0.3, -0.4, -1}, {2.5f, 2.4f, 2.2f});
    addLamp(scene, {4, 6, 8}, {40, 60, 90}, 0.1f);
    scene.cameras.push_back(frontCamera());
    return scene;
}

Scene makeEmpty() {
    Scene scene;
    addSun(scene, {0.3, -0.4, -1}, glm::vec3(2));
    scene.cameras.push_back(frontCamera());
    return scene;
}

} // namespace harness::hard
