// A street with a colonnade, balconies, fences, wires and a pavement cafe.
#include "scene/builtin/brick_texture.h"
#include "scene/builtin/city_parts.h"
#include "scene/builtin/mesh_builder.h"
#include "scene/builtin/scenes.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <array>
#include <cmath>

namespace harness::builtin {

namespace {

// The street runs along z from +kNear to -kFar; houses stand on both sides beyond the pavements.
constexpr float kRoad = 3.2f;  // half its width
constexpr float kHouse = 6.8f; // distance of the house fronts from the middle
constexpr float kHouseLength = 9.0f;
constexpr int kHousesPerSide = 5;
constexpr float kNear = 8.0f;

struct Materials {
    uint32_t asphalt, pavement, brick, plaster, plaster2, stone, frame, darkGlass, litGlass, iron, green, steel, wood,
        wood2, cable, lamp;
};

uint32_t newMaterial(Scene& scene, const char* name, uint32_t color, float roughness, float metallic = 0) {
    addMaterial(scene, name, color, roughness, metallic);
    return lastMaterial(scene);
}

Materials addMaterials(Scene& scene) {
    Materials m;
    m.asphalt = newMaterial(scene, "asphalt", 0x55565a, 0.85f);
    m.pavement = newMaterial(scene, "pavement", 0x9b958a, 0.8f);
    m.brick = newMaterial(scene, "brick", 0xffffff, 0.75f);
    m.plaster = newMaterial(scene, "cream plaster", 0xe3d3ae, 0.8f);
    m.plaster2 = newMaterial(scene, "blue plaster", 0x93a9b8, 0.8f);
    m.stone = newMaterial(scene, "stone", 0xcdc6b6, 0.6f);
    m.frame = newMaterial(scene, "white paint", 0xe8e6df, 0.4f);
    m.darkGlass = newMaterial(scene, "dark window", 0x1f2a33, 0.12f);
    m.litGlass = newMaterial(scene, "lit window", 0x8f7a50, 0.3f);
    scene.materials.back().emissive = {2.2f, 1.5f, 0.7f};
    m.iron = newMaterial(scene, "iron", 0x25272a, 0.35f);
    m.green = newMaterial(scene, "green paint", 0x2f6b4c, 0.35f);
    m.steel = newMaterial(scene, "steel", 0xc4c5c6, 0.25f, 1);
    m.wood = newMaterial(scene, "wood", 0x9a6a3c, 0.55f);
    m.wood2 = newMaterial(scene, "red slats", 0xa83e32, 0.45f);
    m.cable = newMaterial(scene, "cable", 0x1b1b1d, 0.5f);
    m.lamp = newMaterial(scene, "lamp", 0xfff2d8, 0.5f);
    scene.materials.back().emissive = {6.0f, 5.0f, 3.4f};

    BrickTextures textures = brickTextures();
    scene.materials[m.brick].baseColorTexture = int(scene.textures.size());
    scene.textures.push_back(std::move(textures.color));
    scene.materials[m.brick].normalTexture = int(scene.textures.size());
    scene.textures.push_back(std::move(textures.normal));
    return m;
}

void placeNew(Scene& scene, const MeshBuilder& mesh, uint32_t material) {
    place(scene, addMesh(scene, mesh, material));
}

// Turns an object that faces +z towards the road. The side is -1 for left and +1 for right.
glm::dmat4 facingRoad(float side, float x, float y, float z) {
    return placement({side * x, y, z}, -side * glm::half_pi<double>());
}

void addGround(Scene& scene, const Materials& m) {
    const float far = kNear - kHousesPerSide * kHouseLength - 4;
    MeshBuilder road, pavement;
    road.quad({-kRoad, 0, kNear + 6}, {2 * kRoad, 0, 0}, {0, 0, far - kNear - 6});
    pavement.box({-kHouse - 2.4f, -0.2f, far}, {-kRoad, 0.14f, kNear + 6});
    pavement.box({kRoad, -0.2f, far}, {kHouse, 0.14f, kNear + 6});
    pavement.box({-kHouse - 9, -0.2f, far - 8}, {kHouse + 9, 0.05f, far});
    placeNew(scene, road, m.asphalt);
    placeNew(scene, pavement, m.pavement);
}

struct Window {
    uint32_t frame, dark, lit, balcony;
};

void addHouse(Scene& scene, const Materials& m, const Window& window, int index, float side, Random& random) {
    const std::array walls{m.brick, m.plaster, m.brick, m.plaster2};
    const float height = 8.5f + float(random.below(4)) * 1.2f;
    const float front = kNear - kHouseLength * float(index);
    const float middle = front - 0.5f * kHouseLength;
    MeshBuilder wall, trim;
    const float inner = kHouse + (side > 0 ? 0.0f : 2.4f); // the left fronts stand behind a colonnade
    const float low = std::min(side * inner, side * (inner + 6));
    // The brick texture covers a metre.
    wall.box({low, 0, front - kHouseLength}, {low + 6, height, front}, 1.0f);
    const float edge = std::min(side * (inner - 0.25f), side * (inner + 0.2f));
    trim.box({edge, height - 0.35f, front - kHouseLength}, {edge + 0.45f, height, front});
    placeNew(scene, wall, walls[(uint32_t(index) + (side > 0 ? 0u : 1u)) % walls.size()]);
    placeNew(scene, trim, m.stone);
    for (int floor = 0; 1.5f + 2.9f * float(floor) + 1.7f < height - 0.4f; ++floor)
        for (int column = 0; column < 4; ++column) {
            const float z = middle + (float(column) - 1.5f) * 2.1f;
            const glm::dmat4 at = facingRoad(side, inner, 1.1f + 2.9f * float(floor), z);
            place(scene, window.frame, at);
            place(scene, random.below(4) == 0 ? window.lit : window.dark, at);
            if (floor > 0 && side > 0 && (column + index) % 2 == 0)
                place(scene, window.balcony, at);
        }
}

void addHouses(Scene& scene, const Materials& m, Random& random) {
    MeshBuilder pane;
    pane.quad({-0.5f, 0, 0.02f}, {1, 0, 0}, {0, 1.6f, 0});
    const Window window{addMesh(scene, windowFrame(1.0f, 1.6f), m.frame), addMesh(scene, pane, m.darkGlass),
                        addMesh(scene, pane, m.litGlass), addMesh(scene, balcony(1.7f), m.iron)};
    const uint32_t antenna = addMesh(scene, roofAntenna(), m.steel);
    for (int i = 0; i < kHousesPerSide; ++i)
        for (const float side : {-1.0f, 1.0f}) {
            addHouse(scene, m, window, i, side, random);
            const double turn = random.in(0, 6.2832f);
            place(scene, antenna,
                  placement({side * (kHouse + 3.0f), 8.5, kNear - kHouseLength * (i + 0.5)}, turn, 1.6));
        }
}

// The colonnade stands in front of the left houses and carries a roof.
void addColonnade(Scene& scene, const Materials& m) {
    const uint32_t column = addMesh(scene, flutedColumn(0.24f, 3.3f), m.stone);
    const float x = -kHouse + 0.5f;
    for (int i = 0; i < 13; ++i)
        place(scene, column, placement({x, 0.14, kNear - 3.0 * i}, 0));
    MeshBuilder roof;
    roof.box({-kHouse - 2.4f, 3.44f, kNear - 37}, {x + 0.4f, 3.8f, kNear + 1});
    placeNew(scene, roof, m.stone);
}

void addFences(Scene& scene, const Materials& m) {
    const uint32_t railing = addMesh(scene, fencePanel(2.0f, 1.0f, 20, false), m.steel);
    const uint32_t spikes = addMesh(scene, fencePanel(2.2f, 1.5f, 18, true), m.iron);
    const uint32_t painted = addMesh(scene, fencePanel(2.2f, 1.5f, 18, true), m.green);
    for (int i = 0; i < 16; ++i)
        place(scene, railing, facingRoad(1, kRoad + 0.25f, 0.14f, 3.0f - 2.0f * float(i)));
    for (int i = 0; i < 14; ++i)
        place(scene, i % 5 == 4 ? painted : spikes, facingRoad(-1, kRoad + 0.3f, 0.14f, -4.0f - 2.2f * float(i)));
}

// Poles along both kerbs, wires between neighbours and across the street.
void addPolesAndWires(Scene& scene, const Materials& m) {
    const uint32_t pole = addMesh(scene, wirePole(), m.green);
    MeshBuilder bulb;
    bulb.sphere({0.9f, 4.35f, 0}, 0.16f, 8, 12);
    const uint32_t lamp = addMesh(scene, bulb, m.lamp);
    MeshBuilder wires;
    for (int i = 0; i < 6; ++i) {
        const float z = 4.5f - 8.0f * float(i);
        for (const float side : {-1.0f, 1.0f}) {
            const glm::dmat4 at = placement({side * (kRoad + 0.6), 0.14, z}, side > 0 ? glm::pi<double>() : 0.0);
            place(scene, pole, at);
            place(scene, lamp, at);
            if (i == 5)
                continue;
            for (int arm = 0; arm < 4; ++arm) {
                const float x = side * (kRoad + 0.6f) + 0.4f * (float(arm) - 1.5f);
                const float y = 6.47f - (arm % 2 ? 0.0f : 0.5f);
                addWire(wires, {x, y, z}, {x, y, z - 8}, 0.35f);
            }
        }
        for (int k = 0; k < 2; ++k) {
            const float x = kRoad + 0.6f, y = 5.6f + 0.4f * float(k);
            addWire(wires, {-x, y, z}, {x, y, z - 8.0f * float(k)}, 0.3f);
        }
    }
    placeNew(scene, wires, m.cable);
}

void addCafe(Scene& scene, const Materials& m, Random& random) {
    const CafeChair chair = cafeChair();
    const CafeTable table = cafeTable();
    const uint32_t chairTubes = addMesh(scene, chair.tubes, m.steel);
    const std::array slats{addMesh(scene, chair.slats, m.wood), addMesh(scene, chair.slats, m.wood2)};
    const uint32_t tableTubes = addMesh(scene, table.tubes, m.iron);
    const uint32_t tableTop = addMesh(scene, table.top, m.frame);
    for (int i = 0; i < 9; ++i) {
        const glm::dvec3 middle(kRoad + 1.15 + 1.35 * (i % 2), 0.14, 3.6 - 1.75 * i);
        const glm::dmat4 at = placement(middle, random.in(0, 3));
        place(scene, tableTubes, at);
        place(scene, tableTop, at);
        const float first = random.in(0, 6.2832f);
        for (int k = 0; k < 4; ++k) {
            const double turn = first + k * glm::half_pi<double>() + random.in(-0.3f, 0.3f);
            // A chair faces +z; it stands behind its own back from the table.
            const glm::dvec3 away(-std::sin(turn), 0, -std::cos(turn));
            const glm::dmat4 seat = placement(middle + 0.62 * away, turn);
            place(scene, chairTubes, seat);
            place(scene, slats[random.below(2)], seat);
        }
    }
}

} // namespace

Scene makeCity() {
    Scene scene;
    Random random(1879);
    const Materials m = addMaterials(scene);
    addGround(scene, m);
    addHouses(scene, m, random);
    addColonnade(scene, m);
    addFences(scene, m);
    addPolesAndWires(scene, m);
    addCafe(scene, m, random);

    Camera camera;
    camera.name = "street";
    camera.eye = {1.2, 1.9, 8.6};
    camera.target = {0.5, 2.3, -4.0};
    camera.fovDegrees = 55;
    scene.cameras.push_back(camera);
    return scene;
}

} // namespace harness::builtin
