// Thin geometry, far geometry and many layers.
#include "scene/hard/parts.h"

#include <array>
#include <cmath>

namespace harness::hard {

using builtin::MeshBuilder;

Scene makeFarWall() {
    Scene scene;
    MeshBuilder fence, wall;
    for (int i = -16; i <= 16; ++i) // metres
        addRectangle(fence, {0.008f * float(i) - 0.0015f, -0.1f}, {0.008f * float(i) + 0.0015f, 0.03f}, -0.1f);
    for (int i = -20; i < 20; ++i) {
        wall.color = i % 2 ? glm::u8vec4(230, 220, 200, 255) : glm::u8vec4(110, 120, 140, 255);
        addRectangle(wall, {700 * float(i), -7000}, {700 * float(i + 1), 7000}, -10000);
    }
    placeMesh(scene, fence, addLinear(scene, "fence", {0.25f, 0.15f, 0.08f}, 0.5f));
    placeMesh(scene, wall, addLinear(scene, "wall", glm::vec3(0.8f), 0.9f));
    addSun(scene, {0.4, -0.5, -1}, {2.5f, 2.4f, 2.2f});
    Camera camera;
    camera.name = "behind the fence";
    camera.eye = {0, 0, 0};
    camera.target = {0, 0, -0.1};
    scene.cameras.push_back(camera);
    return scene;
}

Scene makeRailings() {
    Scene scene;
    MeshBuilder bars, rails, tiles;
    for (int i = -20; i <= 20; ++i)
        bars.cylinder({1.7f * float(i), -16, 4}, {1.7f * float(i) + 0.4f, 12, 4}, 0.15f, 8);
    for (const float y : {-15.0f, 11.0f})
        rails.cylinder({-36, y, 4}, {36, y + 0.7f, 4}, 0.3f, 8);
    for (int j = -6; j < 6; ++j)
        for (int i = -10; i < 10; ++i) {
            tiles.color = (i + j) % 2 ? glm::u8vec4(190, 180, 160, 255) : glm::u8vec4(90, 100, 110, 255);
            addRectangle(tiles, {4.3f * float(i), 4.3f * float(j)}, {4.3f * float(i + 1), 4.3f * float(j + 1)}, -8);
        }
    placeMesh(scene, bars, addLinear(scene, "bars", {0.8f, 0.8f, 0.85f}, 0.3f, 1));
    placeMesh(scene, rails, addLinear(scene, "rails", {0.3f, 0.05f, 0.04f}, 0.4f));
    placeMesh(scene, tiles, addLinear(scene, "tiles", glm::vec3(0.8f), 0.8f));
    addSun(scene, {0.5, -0.6, -1}, {2.5f, 2.4f, 2.2f}).castsShadow = true;
    addLamp(scene, {-10, 5, 10}, {40, 60, 90}, 0.1f);
    scene.cameras.push_back(frontCamera());
    return scene;
}

Scene makeHair() {
    Scene scene;
    MeshBuilder mesh;
    Random random(23);
    for (int i = 0; i < 700; ++i) {
        const float x = random.in(-34, 34), z = random.in(-6, 6), bend = random.in(-5, 5);
        const std::array points = {glm::vec3(x, -20, z), glm::vec3(x + 0.3f * bend, -8, z + 1),
                                   glm::vec3(x + bend, 6, z - 1), glm::vec3(x + 0.5f * bend, 20, z)};
        const std::vector<glm::vec3> curve = builtin::smoothCurve(points, 5);
        const std::vector<float> widths(curve.size(), 0.125f);
        const uint8_t tint = uint8_t(110 + random.below(120));
        mesh.color = {tint, uint8_t(0.7f * float(tint)), uint8_t(tint / 2), 255};
        mesh.blade(curve, widths, {1, 0, random.in(-0.8f, 0.8f)});
    }
    placeMesh(scene, mesh, addLinear(scene, "hair", glm::vec3(0.8f), 0.3f));
    scene.materials.back().doubleSided = true;
    addBackdrop(scene, -12, {0.2f, 0.22f, 0.25f});
    addSun(scene, {0.4, -0.5, -1}, {2.5f, 2.4f, 2.2f});
    addSun(scene, {-0.7, -0.1, -0.7}, {0.8f, 1, 1.4f});
    scene.cameras.push_back(frontCamera());
    return scene;
}

// Returns a transparent texture with four opaque discs, which cover a hundredth of it.
static Texture discTexture() {
    constexpr int size = 128;
    Texture texture;
    texture.name = "discs";
    texture.width = texture.height = size;
    texture.srgb = true;
    texture.rgba.assign(size_t(size) * size * 4, 255);
    constexpr std::array<glm::vec2, 4> centres = {glm::vec2(21, 30), {90, 17}, {55, 77}, {108, 103}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            float nearest = 1e9f;
            for (const glm::vec2& centre : centres)
                nearest = std::min(nearest, glm::distance(centre, glm::vec2(x, y)));
            const float alpha = std::clamp(0.5f + (4 - nearest), 0.0f, 1.0f);
            texture.rgba[(size_t(y) * size + size_t(x)) * 4 + 3] = uint8_t(255 * alpha + 0.5f);
        }
    return texture;
}

Scene makeCutouts() {
    Scene scene;
    MeshBuilder mesh;
    Random random(40);
    for (int layer = 0; layer < 1000; ++layer) {
        const float z = -10 + 0.02f * float(layer), scale = (50 - z) / 50 * 1.1f;
        mesh.color = {uint8_t(60 + random.below(196)), uint8_t(60 + random.below(196)), uint8_t(layer / 4), 255};
        const size_t first = mesh.vertices.size();
        mesh.quad({-32 * scale, -18 * scale, z}, {64 * scale, 0, 0}, {0, 36 * scale, 0}, {1, 0.5625f});
        const glm::vec2 shift{random.unit(), random.unit()};
        for (size_t i = first; i < mesh.vertices.size(); ++i)
            mesh.vertices[i].uv += shift;
    }
    scene.textures.push_back(discTexture());
    const uint32_t material = addLinear(scene, "discs", glm::vec3(0.9f), 0.6f);
    scene.materials[material].alphaMode = AlphaMode::Mask;
    scene.materials[material].baseColorTexture = 0;
    placeMesh(scene, mesh, material);
    addSun(scene, {0.4, -0.5, -1}, {2.5f, 2.4f, 2.2f});
    scene.cameras.push_back(frontCamera());
    return scene;
}

} // namespace harness::hard
