// A grove of glossy stalks with narrow leaves, after the Bamboo scene of the papers.
#include "scene/builtin/mesh_builder.h"
#include "scene/builtin/scenes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace harness::builtin {

namespace {

constexpr int kStalks = 120;
constexpr int kVariants = 6;
constexpr int kSegments = 16; // segments of a stalk, between two nodes each
constexpr int kLeavesPerStalk = 180;

struct Stalk {
    std::vector<glm::vec3> nodes; // joints between segments, from the ground up
    float radius;
};

Stalk stalkShape(Random& random) {
    Stalk stalk;
    const float height = random.in(6.5f, 9.5f);
    stalk.radius = random.in(0.028f, 0.045f);
    const glm::vec2 lean{random.in(-0.5f, 0.5f), random.in(-0.5f, 0.5f)};
    for (int i = 0; i <= kSegments; ++i) {
        // Segments are shorter at the foot, and the lean grows with the height.
        const float s = float(i) / kSegments;
        const float h = 0.65f * s + 0.35f * s * s;
        stalk.nodes.push_back({lean.x * s * s * s, height * h, lean.y * s * s * s});
    }
    return stalk;
}

// Three rings per segment: above the swollen node, in the middle, below the next node.
MeshBuilder stalkMesh(const Stalk& stalk) {
    std::vector<glm::vec3> points;
    std::vector<float> radii;
    for (size_t i = 0; i < kSegments; ++i) {
        const glm::vec3 &a = stalk.nodes[i], &b = stalk.nodes[i + 1];
        const float taper = 1 - 0.75f * float(i) / kSegments;
        points.insert(points.end(), {a, glm::mix(a, b, 0.06f), glm::mix(a, b, 0.9f)});
        radii.insert(radii.end(),
                     {1.16f * taper * stalk.radius, 0.93f * taper * stalk.radius, 0.96f * taper * stalk.radius});
    }
    points.push_back(stalk.nodes.back());
    radii.push_back(0.15f * stalk.radius);
    MeshBuilder mesh;
    mesh.tube(points, radii, 8, false);
    return mesh;
}

void addLeaf(MeshBuilder& mesh, const glm::vec3& base, const glm::vec3& direction, Random& random) {
    const float length = random.in(0.18f, 0.34f);
    const float width = random.in(0.012f, 0.022f);
    const float tint = random.in(0.65f, 1.0f);
    const float red = random.in(0.8f, 1.0f);
    const float blue = random.in(0.6f, 1.0f);
    mesh.color = glm::u8vec4(255.0f * glm::vec4(tint * red, tint, tint * blue, 1));
    const glm::vec3 fall{0, -length * random.in(0.15f, 0.5f), 0};
    const std::array points{base, base + 0.45f * length * direction + 0.25f * fall, base + length * direction + fall};
    const std::array widths{0.25f * width, width, 0.0f};
    const glm::vec3 level = glm::cross(direction, glm::vec3(0, 1, 0));
    const glm::vec3 roll = 0.5f * unitVector(random);
    mesh.blade(points, widths, glm::normalize(level + glm::vec3(0.01f, 0, 0)) + roll);
}

struct Leaves {
    MeshBuilder twigs, leaves;
};

// Twigs leave the stalk at its nodes and carry fans of leaves.
Leaves leavesOf(const Stalk& stalk, Random& random) {
    constexpr int perTwig = 10;
    Leaves result;
    for (int i = 0; i < kLeavesPerStalk / perTwig; ++i) {
        const size_t node = 5 + random.below(kSegments - 5);
        const glm::vec3 foot = stalk.nodes[node];
        const float turn = random.in(0, 6.2832f);
        const float reach = random.in(0.35f, 0.95f) * (1.25f - float(node) / kSegments * 0.5f);
        const glm::vec3 out{std::cos(turn), 0, std::sin(turn)};
        const std::array points{foot, foot + 0.5f * reach * out + glm::vec3(0, 0.28f * reach, 0),
                                foot + reach * out + glm::vec3(0, 0.32f * reach, 0)};
        const std::array radii{0.006f, 0.004f, 0.0015f};
        result.twigs.tube(points, radii, 3, false);
        for (int leaf = 0; leaf < perTwig; ++leaf) {
            const float along = random.in(0.45f, 1.0f);
            const glm::vec3 base = along < 0.5f ? glm::mix(points[0], points[1], 2 * along)
                                                : glm::mix(points[1], points[2], 2 * along - 1);
            const float spread = turn + random.in(-1.2f, 1.2f);
            const glm::vec3 direction{std::cos(spread), random.in(-0.5f, 0.4f), std::sin(spread)};
            addLeaf(result.leaves, base, glm::normalize(direction), random);
        }
    }
    return result;
}

// Dry leaves and short shoots on the ground.
MeshBuilder litter(Random& random) {
    MeshBuilder mesh;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 base{random.in(-9, 9), random.in(0.01f, 0.05f), random.in(-9, 9)};
        const float turn = random.in(0, 6.2832f);
        const glm::vec3 direction{std::cos(turn), random.in(0.0f, 0.25f), std::sin(turn)};
        addLeaf(mesh, base, glm::normalize(direction), random);
    }
    return mesh;
}

float soil(float x, float z) { return 0.06f * std::sin(0.9f * x + 0.4f) * std::cos(0.7f * z) - 0.03f; }

// Returns the feet of the stalks. They are at least a hand's breadth apart and leave the path to the eye free.
std::vector<glm::vec2> feet(Random& random) {
    std::vector<glm::vec2> result;
    while (result.size() < kStalks) {
        const glm::vec2 p{random.in(-6.5f, 6.5f), random.in(-7.5f, 5.5f)};
        const bool path = std::abs(p.x - 0.15f * p.y) < 0.7f && p.y > -2;
        const bool crowded =
            std::any_of(result.begin(), result.end(), [&](const glm::vec2& q) { return glm::distance(p, q) < 0.35f; });
        if (!path && !crowded)
            result.push_back(p);
    }
    return result;
}

} // namespace

Scene makeBamboo() {
    Scene scene;
    Random random(2016);
    const std::array<uint32_t, kVariants> stalkColors{0x6f8f3a, 0x8a9a45, 0x4f7a34, 0xa89a4c, 0x5d8540, 0x7c8c50};
    const std::array<uint32_t, 3> leafColors{0x5f8f35, 0x86a843, 0x437a38};
    addMaterial(scene, "soil", 0x6b5a44, 0.9f);
    const uint32_t earth = lastMaterial(scene);
    addMaterial(scene, "dry leaves", 0xb09a63, 0.65f).doubleSided = true;
    const uint32_t dry = lastMaterial(scene);
    addMaterial(scene, "twigs", 0x7a8048, 0.45f);
    const uint32_t twigs = lastMaterial(scene);
    const uint32_t firstLeaf = uint32_t(scene.materials.size());
    for (const uint32_t color : leafColors)
        addMaterial(scene, "leaves", color, 0.38f).doubleSided = true;

    struct Variant {
        uint32_t stalk, twigs, leaves;
    };
    std::vector<Variant> variants;
    for (uint32_t i = 0; i < kVariants; ++i) {
        addMaterial(scene, "stalk", stalkColors[i], random.in(0.18f, 0.3f));
        const uint32_t stalkMaterial = lastMaterial(scene);
        const Stalk stalk = stalkShape(random);
        const Leaves leaves = leavesOf(stalk, random);
        variants.push_back({addMesh(scene, stalkMesh(stalk), stalkMaterial), addMesh(scene, leaves.twigs, twigs),
                            addMesh(scene, leaves.leaves, firstLeaf + i % uint32_t(leafColors.size()))});
    }
    for (const glm::vec2& foot : feet(random)) {
        const Variant& variant = variants[random.below(kVariants)];
        const double turn = random.in(0, 6.2832f);
        const double scale = random.in(0.8f, 1.1f);
        const double lean = random.in(-0.04f, 0.04f);
        const glm::dmat4 transform = placement({foot.x, soil(foot.x, foot.y) - 0.05f, foot.y}, turn, scale, lean);
        place(scene, variant.stalk, transform);
        place(scene, variant.twigs, transform);
        place(scene, variant.leaves, transform);
    }
    MeshBuilder ground;
    ground.ground(14, 40, soil, 0.5f);
    place(scene, addMesh(scene, ground, earth));
    place(scene, addMesh(scene, litter(random), dry));

    Camera camera;
    camera.name = "path";
    camera.eye = {1.0, 1.6, 9.5};
    camera.target = {-0.2, 3.1, -1.0};
    camera.fovDegrees = 50;
    scene.cameras.push_back(camera);
    return scene;
}

} // namespace harness::builtin
