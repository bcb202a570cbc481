// Lights at the ends of their ranges, and a checker that correlates light and material.
#include "scene/hard/parts.h"

#include <numbers>

namespace harness::hard {

using builtin::MeshBuilder;

namespace {

// A floor that faces the camera, which the lights of a scene touch.
Scene floorScene() {
    Scene scene;
    addBackdrop(scene, 0, {0.5f, 0.48f, 0.45f});
    scene.materials.back().roughness = 0.5f;
    scene.cameras.push_back(frontCamera());
    return scene;
}

} // namespace

Scene makeLightOnSurface() {
    Scene scene = floorScene();
    // Heights of a fortieth of a pixel to half of one, over a centre, an edge and a corner of pixels.
    addLamp(scene, {-20.5, 5.5, 0.025}, {3, 2, 1}, 0.2f);
    addLamp(scene, {0, 0.5, 0.1}, {1, 3, 1}, 0.2f);
    addLamp(scene, {16, -8, 0.25}, {1, 1, 3}, 0.05f);
    addLamp(scene, {24.5, 8.5, 0.5}, {2, 2, 2}, 0.01f);
    return scene;
}

Scene makeLightInSurface() {
    Scene scene = floorScene();
    // Slopes rise from the floor at these distances from the lamps, which lie in the floor and in a fin across it.
    const auto addSlope = [&scene](const glm::vec3& lamp, float distance) {
        MeshBuilder slope;
        slope.quad({lamp.x + distance, -12, 0}, {8, 0, 4}, {0, 24, 0});
        slope.quad({lamp.x - 6, lamp.y, 0}, {4, 0, 0}, {0, 0.5f, 3});
        placeMesh(scene, slope, addLinear(scene, "slope", {0.6f, 0.3f, 0.2f}, 0.4f));
        scene.materials.back().doubleSided = true;
    };
    addLamp(scene, {-20.5, 5.5, 0}, {3, 2, 1}, 0.2f);
    addSlope({-20.5f, 5.5f, 0}, 1);
    addLamp(scene, {0, 0.5, 0}, {1, 3, 1}, 0.05f);
    addSlope({0, 0.5f, 0}, 0.4f);
    addLamp(scene, {16, -8, 0}, {1, 1, 3}, 0.01f);
    addSlope({16, -8, 0}, 0.1f);
    return scene;
}

Scene makeLightInside() {
    Scene scene = floorScene();
    MeshBuilder shapes;
    shapes.sphere({-14, 0, 7}, 6, 16, 24);
    shapes.box({8, -5, 1}, {18, 5, 9});
    placeMesh(scene, shapes, addLinear(scene, "shapes", {0.3f, 0.5f, 0.35f}, 0.3f));
    addSun(scene, {0.4, -0.5, -1}, {0.6f, 0.6f, 0.55f});
    addLamp(scene, {-14, 0, 7}, {200, 150, 100}, 0.1f).castsShadow = true;
    addLamp(scene, {13, 0, 5}, {100, 150, 200}, 0.1f).castsShadow = true;
    return scene;
}

Scene makeLightWithoutRadius() {
    Scene scene = floorScene();
    addLamp(scene, {-20.5, 5.5, 0}, {3, 2, 1}, 0);
    addLamp(scene, {0, 0.5, 0.3}, {1, 3, 1}, 0);
    addLamp(scene, {16, -8, 2}, {4, 4, 12}, 0);
    return scene;
}

Scene makeSpots() {
    Scene scene = floorScene();
    for (int i = 0; i < 4; ++i) {
        Light& spot = addLamp(scene, {-24 + 16.3 * i, 0.2, 20}, {500, 400, 300}, 0.1f);
        spot.type = LightType::Spot;
        spot.direction = glm::normalize(glm::dvec3(0.1, -0.05, -1));
        spot.outerCone = i == 3 ? float(std::numbers::pi / 2) : 0.1f * float(i + 1); // the last one is a half space
        spot.innerCone = spot.outerCone;
        if (i == 3)
            spot.color *= 0.2f;
    }
    return scene;
}

Scene makeChecker() {
    Scene scene;
    MeshBuilder tiles, plate;
    // A sun along (1, 0, -1) moves shadows by 40 units along x from a plate at z = 40. The plate lies outside the view.
    for (int j = -20; j < 20; ++j)
        for (int i = -34; i < 32; ++i) {
            const glm::vec2 low(float(i) + 0.5f, float(j) + 0.5f);
            const bool isLit = (i + j) % 2 == 0;
            tiles.color = isLit ? glm::u8vec4(20, 220, 20, 255) : glm::u8vec4(220, 20, 20, 255);
            addRectangle(tiles, low, low + 1.0f, 0);
            if (!isLit)
                addRectangle(plate, low - glm::vec2(40, 0), low + glm::vec2(-39, 1), 40);
        }
    placeMesh(scene, tiles, addLinear(scene, "tiles", glm::vec3(1), 0.9f));
    placeMesh(scene, plate, addLinear(scene, "plate", glm::vec3(0.5f), 0.9f));
    scene.materials.back().doubleSided = true;
    addSun(scene, {1, 0, -1}, {3, 3, 3}).castsShadow = true;
    scene.cameras.push_back(frontCamera());
    return scene;
}

} // namespace harness::hard
