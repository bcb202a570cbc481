// Bushes and trees of alpha-masked leaf cards in a meadow of grass blades.
#include "scene/builtin/leaf_texture.h"
#include "scene/builtin/mesh_builder.h"
#include "scene/builtin/scenes.h"

#include <array>
#include <cmath>

namespace harness::builtin {

namespace {

constexpr int kBushes = 34;
constexpr int kGrassPatches = 56;
constexpr int kBladesPerPatch = 420;

float meadow(float x, float z) { return 0.18f * std::sin(0.35f * x) * std::cos(0.28f * z + 0.5f); }

// A square card with its foot at `base`, growing along `up`.
void addCard(MeshBuilder& mesh, const glm::vec3& base, const glm::vec3& up, float size, Random& random) {
    const glm::vec3 spun = glm::cross(up, unitVector(random));
    const glm::vec3 across =
        glm::length(spun) > 0.05f ? glm::normalize(spun) : glm::normalize(glm::cross(up, glm::vec3(0.6f, 0, 0.8f)));
    const uint8_t tint = uint8_t(165 + random.below(91));
    mesh.color = {tint, tint, tint, 255};
    mesh.quad(base - 0.5f * size * across, size * across, size * up);
}

// Cards through an ellipsoid, denser near its surface, pointing outwards and up.
void addCrown(MeshBuilder& mesh, const glm::vec3& centre, const glm::vec3& radii, int cards, float size,
              Random& random) {
    for (int i = 0; i < cards; ++i) {
        const glm::vec3 n = unitVector(random);
        const float depth = random.in(0.55f, 1.0f);
        const glm::vec3 lean = 0.6f * unitVector(random) + glm::vec3(0, 0.35f, 0);
        addCard(mesh, centre + depth * radii * n, glm::normalize(n + lean), size * random.in(0.75f, 1.2f), random);
    }
}

struct Plant {
    MeshBuilder wood, leaves;
};

Plant bush(Random& random) {
    Plant plant;
    for (int i = 0; i < 7; ++i) {
        const glm::vec3 n = unitVector(random);
        const std::array points{glm::vec3(0), glm::vec3(0.25f * n.x, 0.45f, 0.25f * n.z),
                                glm::vec3(0.6f * n.x, 0.9f, 0.6f * n.z)};
        const std::array radii{0.025f, 0.015f, 0.005f};
        plant.wood.tube(points, radii, 5, false);
    }
    addCrown(plant.leaves, {0, 0.72f, 0}, {0.8f, 0.62f, 0.8f}, 420, 0.3f, random);
    return plant;
}

Plant tree(Random& random) {
    Plant plant;
    const std::array trunk{glm::vec3(0, -0.1f, 0), glm::vec3(0.06f, 1.2f, 0.04f), glm::vec3(-0.05f, 2.6f, 0.1f),
                           glm::vec3(0.05f, 4.3f, 0)};
    const std::array radii{0.2f, 0.14f, 0.11f, 0.03f};
    plant.wood.tube(trunk, radii, 10, false);
    for (int i = 0; i < 14; ++i) {
        const float turn = float(i) * 2.4f;
        const float height = random.in(1.9f, 3.9f);
        const float reach = random.in(0.9f, 1.6f);
        const glm::vec3 out{std::cos(turn), 0, std::sin(turn)};
        const glm::vec3 foot{0, height, 0};
        const std::array branch{foot, foot + 0.5f * reach * out + glm::vec3(0, 0.25f * reach, 0),
                                foot + reach * out + glm::vec3(0, 0.35f * reach, 0)};
        const std::array branchRadii{0.05f, 0.03f, 0.008f};
        plant.wood.tube(branch, branchRadii, 6, false);
        addCrown(plant.leaves, branch[2], {0.75f, 0.55f, 0.75f}, 90, 0.38f, random);
    }
    addCrown(plant.leaves, {0, 4.1f, 0}, {0.9f, 0.7f, 0.9f}, 160, 0.38f, random);
    return plant;
}

MeshBuilder grass(float halfSize, Random& random) {
    MeshBuilder mesh;
    for (int i = 0; i < kBladesPerPatch; ++i) {
        const glm::vec3 base{random.in(-halfSize, halfSize), -0.03f, random.in(-halfSize, halfSize)};
        const float turn = random.in(0, 6.2832f);
        const glm::vec3 side{std::cos(turn), 0, std::sin(turn)};
        const glm::vec3 out{-side.z, 0, side.x};
        const float height = random.in(0.12f, 0.38f);
        const float bend = height * random.in(0.1f, 0.6f);
        const std::array points{base, base + glm::vec3(0, 0.6f * height, 0) + 0.3f * bend * out,
                                base + glm::vec3(0, height, 0) + bend * out};
        const std::array widths{0.009f, 0.007f, 0.0f};
        const uint8_t tint = uint8_t(150 + random.below(106));
        mesh.color = {tint, tint, uint8_t(tint / 2 + random.below(100)), 255};
        mesh.blade(points, widths, side);
    }
    return mesh;
}

uint32_t addLeafMaterial(Scene& scene, const LeafPicture& picture) {
    scene.textures.push_back(leafTexture(picture));
    Material& material = addMaterial(scene, "leaves", 0xffffff, 0.5f);
    material.alphaMode = AlphaMode::Mask;
    material.doubleSided = true;
    material.baseColorTexture = int(scene.textures.size()) - 1;
    return lastMaterial(scene);
}

struct Placed {
    uint32_t wood, leaves;
};

void placePlant(Scene& scene, const Placed& plant, float x, float z, Random& random) {
    const double turn = random.in(0, 6.2832f);
    const double scale = random.in(0.75f, 1.25f);
    const glm::dmat4 transform = placement({x, meadow(x, z), z}, turn, scale);
    place(scene, plant.wood, transform);
    place(scene, plant.leaves, transform);
}

} // namespace

Scene makeFoliage() {
    Scene scene;
    Random random(1609);
    addMaterial(scene, "earth", 0x59663a, 0.9f);
    const uint32_t earth = lastMaterial(scene);
    addMaterial(scene, "bark", 0x6e5640, 0.8f);
    const uint32_t bark = lastMaterial(scene);
    const std::array leafMaterials{addLeafMaterial(scene, {11, 9, 0.42f, 0.36f, 0x4f7d33, 0x86a84a}),
                                   addLeafMaterial(scene, {12, 13, 0.36f, 0.2f, 0x6f8f45, 0xb0b860}),
                                   addLeafMaterial(scene, {13, 7, 0.45f, 0.5f, 0x93432f, 0xcf8a3c})};
    const uint32_t firstGrass = uint32_t(scene.materials.size());
    addMaterial(scene, "green grass", 0x7fa548, 0.45f).doubleSided = true;
    addMaterial(scene, "dry grass", 0xc2b46c, 0.5f).doubleSided = true;

    std::array<Placed, 3> bushes, trees;
    for (size_t i = 0; i < 3; ++i) {
        const Plant low = bush(random);
        bushes[i] = {addMesh(scene, low.wood, bark), addMesh(scene, low.leaves, leafMaterials[i])};
        const Plant high = tree(random);
        trees[i] = {addMesh(scene, high.wood, bark), addMesh(scene, high.leaves, leafMaterials[i])};
    }
    const float patch = 1.1f;
    std::array<uint32_t, 4> grasses;
    for (uint32_t i = 0; i < 4; ++i)
        grasses[i] = addMesh(scene, grass(patch, random), firstGrass + (i == 3 ? 1 : 0));

    const std::array treeFeet{glm::vec2(-3.6f, -2.5f), glm::vec2(3.4f, -3.5f), glm::vec2(0.4f, -7.5f),
                              glm::vec2(-7.2f, -6.0f), glm::vec2(7.0f, -7.0f)};
    for (size_t i = 0; i < treeFeet.size(); ++i)
        placePlant(scene, trees[i % 3], treeFeet[i].x, treeFeet[i].y, random);
    for (uint32_t i = 0; i < kBushes; ++i) {
        // Two hedges that open towards the eye, and the rest of them behind.
        const float side = i % 2 ? 1.0f : -1.0f;
        const float z = 3.0f - 0.75f * float(i / 2) + random.in(-0.3f, 0.3f);
        const float x = side * (2.1f + 0.12f * (3 - z) + random.in(0.0f, 1.6f));
        placePlant(scene, bushes[random.below(3)], x, z, random);
    }
    for (uint32_t i = 0; i < kGrassPatches; ++i) {
        const float x = (float(i % 7) - 3) * 1.9f + random.in(-0.3f, 0.3f);
        const float z = 5.5f - 1.9f * float(i / 7) + random.in(-0.3f, 0.3f);
        const double turn = random.in(0, 6.2832f);
        place(scene, grasses[random.below(4)], placement({x, meadow(x, z), z}, turn));
    }
    MeshBuilder ground;
    ground.ground(16, 48, meadow, 0.5f);
    place(scene, addMesh(scene, ground, earth));

    Camera camera;
    camera.name = "meadow";
    camera.eye = {0.6, 1.5, 8.2};
    camera.target = {-0.1, 1.5, -1.0};
    camera.fovDegrees = 50;
    scene.cameras.push_back(camera);
    return scene;
}

} // namespace harness::builtin
