// The built-in scenes: equal on every run, well formed, of the size they promise, in view.
#include "scene/builtin.h"
#include "scene_support.h"

#include <chrono>
#include <set>

using namespace harness;
using namespace scene_test;

namespace {

struct Expected {
    const char* name;
    uint64_t least, most; // placed triangles
};

// Otherwise GoogleTest prints the bytes, addresses among them.
void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.name; }

class BuiltinSceneTest : public testing::TestWithParam<Expected> {};

uint64_t hashOf(const void* data, size_t size, uint64_t hash) {
    const auto* bytes = static_cast<const uint8_t*>(data);
    for (size_t i = 0; i < size; ++i)
        hash = (hash ^ bytes[i]) * 0x100000001b3ull;
    return hash;
}

template <typename T> uint64_t hashOf(const std::vector<T>& list, uint64_t hash) {
    return hashOf(list.data(), list.size() * sizeof(T), hash);
}

uint64_t hashOf(const Scene& scene) {
    static_assert(sizeof(Vertex) == 52, "no padding, whose bytes would be arbitrary");
    uint64_t hash = hashOf(scene.indices, hashOf(scene.vertices, 0xcbf29ce484222325ull));
    for (const Instance& instance : scene.instances)
        hash = hashOf(&instance.transform, sizeof instance.transform, hash ^ instance.mesh);
    for (const Texture& texture : scene.textures)
        hash = hashOf(texture.rgba, hash);
    for (const Material& material : scene.materials)
        hash = hashOf(&material.baseColor, sizeof material.baseColor, hash);
    return hash;
}

// Share of placed triangles that are narrower than a pixel of a 640 x 360 image, of those in view.
double thinShare(const Scene& scene, const Camera& camera) {
    constexpr double width = 640, height = 360;
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::dvec3 up = glm::cross(right, forward);
    const double scale = height / 2 / std::tan(glm::radians(camera.fovDegrees) / 2);
    uint64_t seen = 0, thin = 0;
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        for (uint32_t i = 0; i < mesh.indexCount; i += 3) {
            glm::dvec2 p[3];
            bool inView = true;
            for (uint32_t c = 0; c < 3; ++c) {
                const glm::vec3& position = cornerOf(scene, mesh, i + c).position;
                const glm::dvec3 q = glm::dvec3(instance.transform * glm::dvec4(position, 1)) - camera.eye;
                const double depth = glm::dot(q, forward);
                p[c] = scale / depth * glm::dvec2(glm::dot(q, right), glm::dot(q, up));
                inView = inView && depth > 0.05 && std::abs(p[c].x) < width / 2 && std::abs(p[c].y) < height / 2;
            }
            if (!inView)
                continue;
            const glm::dvec2 a = p[1] - p[0], b = p[2] - p[0];
            const double longest = std::max({glm::length(a), glm::length(b), glm::length(p[2] - p[1])});
            seen += 1;
            thin += std::abs(a.x * b.y - a.y * b.x) < longest; // height below 1
        }
    }
    return seen ? double(thin) / double(seen) : 0;
}

} // namespace

TEST_P(BuiltinSceneTest, IsWellFormed) {
    const Scene scene = *makeBuiltinScene(GetParam().name);
    expectWellFormed(scene);
    EXPECT_EQ(scene.name, GetParam().name);
    EXPECT_FALSE(scene.stresses.empty());
    EXPECT_GE(scene.placedTriangles(), GetParam().least);
    EXPECT_LE(scene.placedTriangles(), GetParam().most);
}

TEST_P(BuiltinSceneTest, IsTheSameTwice) {
    EXPECT_EQ(hashOf(*makeBuiltinScene(GetParam().name)), hashOf(*makeBuiltinScene(GetParam().name)));
}

TEST_P(BuiltinSceneTest, IsMadeInASecond) {
    const auto start = std::chrono::steady_clock::now();
    makeBuiltinScene(GetParam().name);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

TEST_P(BuiltinSceneTest, NormalsAgreeWithTheWinding) {
    const Scene scene = *makeBuiltinScene(GetParam().name);
    uint64_t flipped = 0, flat = 0;
    for (const Mesh& mesh : scene.meshes)
        for (uint32_t i = 0; i < mesh.indexCount; i += 3) {
            const Vertex &a = cornerOf(scene, mesh, i), &b = cornerOf(scene, mesh, i + 1),
                         &c = cornerOf(scene, mesh, i + 2);
            const glm::dvec3 side = glm::cross(glm::dvec3(b.position) - glm::dvec3(a.position),
                                               glm::dvec3(c.position) - glm::dvec3(a.position));
            flat += !(glm::length(side) > 0);
            flipped += glm::dot(side, glm::dvec3(a.normal + b.normal + c.normal)) < 0;
        }
    EXPECT_EQ(flipped, 0u);
    EXPECT_EQ(flat, 0u);
}

TEST_P(BuiltinSceneTest, CameraSeesThinGeometry) {
    const Scene scene = *makeBuiltinScene(GetParam().name);
    ASSERT_FALSE(scene.cameras.empty());
    const Camera& camera = scene.cameras[0];
    EXPECT_TRUE(inside(scene, camera.target));
    EXPECT_GT(glm::length(camera.target - camera.eye), 0.1);
    EXPECT_GT(shareInView(scene, camera), 0.3);
    EXPECT_GT(thinShare(scene, camera), 0.3);
}

INSTANTIATE_TEST_SUITE_P(Scenes, BuiltinSceneTest,
                         testing::Values(Expected{"bamboo", 150000, 200000}, Expected{"foliage", 100000, 150000},
                                         Expected{"furball", 200000, 300000}, Expected{"metal", 100000, 150000},
                                         Expected{"city", 80000, 120000}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(BuiltinScenes, TheListNamesEveryScene) {
    std::set<std::string_view> names;
    for (const BuiltinScene& scene : builtinScenes()) {
        names.insert(scene.name);
        EXPECT_FALSE(scene.stresses.empty());
        EXPECT_TRUE(makeBuiltinScene(scene.name).has_value()) << scene.name;
    }
    EXPECT_EQ(names, (std::set<std::string_view>{"bamboo", "city", "foliage", "furball", "metal"}));
    EXPECT_FALSE(makeBuiltinScene("bambu").has_value());
    EXPECT_FALSE(makeBuiltinScene("").has_value());
}

TEST(BuiltinScenes, BladesAreAsManyAsTheNameSays) {
    const uint64_t none = makeBuiltinScene("blades-0")->placedTriangles();
    EXPECT_GT(none, 1000u) << "the railing and the ground";
    for (const uint32_t count : {1u, 500u, 8000u}) {
        const Scene scene = *makeBuiltinScene("blades-" + std::to_string(count));
        EXPECT_EQ(scene.placedTriangles() - none, 5u * count);
        EXPECT_EQ(scene.name, "blades-" + std::to_string(count));
    }
    for (const char* name : {"blades-", "blades-x", "blades-1x", "blades--1", "blades-100001", "blades-99999999999"})
        EXPECT_FALSE(makeBuiltinScene(name).has_value()) << name;
}

TEST(BuiltinScenes, FoliageIsMaskedAndTheCityIsNormalMapped) {
    const Scene foliage = *makeBuiltinScene("foliage");
    bool masked = false;
    for (const Material& material : foliage.materials) {
        if (material.alphaMode != AlphaMode::Mask)
            continue;
        masked = true;
        EXPECT_TRUE(material.doubleSided);
        const Texture& texture = foliage.textures.at(size_t(material.baseColorTexture));
        EXPECT_EQ(texture.width, 256u);
        size_t clear = 0, soft = 0, solid = 0;
        for (size_t i = 3; i < texture.rgba.size(); i += 4)
            ++(texture.rgba[i] == 0 ? clear : texture.rgba[i] == 255 ? solid : soft);
        EXPECT_GT(clear, 10000u);
        EXPECT_GT(soft, 1000u);
        EXPECT_GT(solid, 3000u);
    }
    EXPECT_TRUE(masked);

    const Scene city = *makeBuiltinScene("city");
    bool mapped = false, emissive = false;
    for (const Material& material : city.materials) {
        emissive = emissive || material.emissive.r > 0;
        if (material.normalTexture < 0)
            continue;
        mapped = true;
        const Texture& texture = city.textures.at(size_t(material.normalTexture));
        EXPECT_FALSE(texture.srgb);
        for (size_t i = 0; i < texture.rgba.size(); i += 4) {
            const glm::vec3 n = glm::vec3(texture.rgba[i], texture.rgba[i + 1], texture.rgba[i + 2]) / 127.5f - 1.0f;
            ASSERT_NEAR(glm::length(n), 1, 0.01);
            ASSERT_GT(n.z, 0);
        }
    }
    EXPECT_TRUE(mapped);
    EXPECT_TRUE(emissive);
}
