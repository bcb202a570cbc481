// Real scenes that other people made, where the machine has them.
#include "scene/gltf.h"
#include "scene/tangents.h"
#include "scene_support.h"

#include <cstdlib>
#include <filesystem>

using namespace harness;
using namespace scene_test;

namespace {

struct SharedScene {
    const char* name;
    // Counted by another program from the files' node trees. Their README's figures for the two
    // tracks are from before their invisible walls were removed: 414,374 and 276,896.
    uint64_t placed;
    glm::dvec3 extent; // by the README; each node's box is transformed, so ours may be larger
};

// Otherwise GoogleTest prints the bytes, addresses among them.
void PrintTo(const SharedScene& scene, std::ostream* out) { *out << scene.name; }

std::filesystem::path folder() {
    const char* named = std::getenv("AGAA_SCENES");
    return named ? std::filesystem::path(named) : std::filesystem::path(AGAA_SOURCE_DIR) / ".." / "shared" / "scenes";
}

std::string missing(const std::filesystem::path& path) {
    return path.filename().string() + " is missing. Set $AGAA_SCENES to a folder that has each scene as NAME/NAME.glb.";
}

class SharedSceneTest : public testing::TestWithParam<SharedScene> {
protected:
    void SetUp() override {
        path = folder() / GetParam().name / (std::string(GetParam().name) + ".glb");
        if (!std::filesystem::exists(path))
            GTEST_SKIP() << missing(path);
    }
    std::filesystem::path path;
};

} // namespace

TEST_P(SharedSceneTest, Loads) {
    const Scene scene = loadGltf(path);
    expectWellFormed(scene, false);
    EXPECT_EQ(scene.name, GetParam().name);
    EXPECT_EQ(scene.placedTriangles(), GetParam().placed);
    const glm::dvec3 size = scene.boundsMax - scene.boundsMin;
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(size[c], 0.95 * GetParam().extent[c]);
        EXPECT_LE(size[c], 1.25 * GetParam().extent[c]);
    }
    for (const Mesh& mesh : scene.meshes) {
        if (scene.materials[mesh.material].normalTexture < 0)
            continue;
        for (uint32_t i = 0; i < mesh.vertexCount; ++i) {
            const Vertex& v = scene.vertices[mesh.firstVertex + i];
            ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-3);
            ASSERT_NEAR(glm::dot(glm::vec3(v.tangent), v.normal), 0, 1e-3);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SharedSceneTest,
                         testing::Values(SharedScene{"stk_gran_paradiso", 388222, {1058.7, 241.7, 2166.0}},
                                         SharedScene{"stk_ravenbridge_mansion", 275620, {1079.2, 701.3, 1233.6}},
                                         SharedScene{"fg_carrier", 99099, {335.7, 68.2, 86.7}},
                                         SharedScene{"sh3d_foliage", 1463493, {16.7, 12.0, 11.5}},
                                         SharedScene{"khronos_flight_helmet", 94722, {0.36, 0.67, 0.36}}),
                         [](const auto& info) { return std::string(info.param.name); });

// The Khronos model brings tangents: those made from its texture coordinates have to agree, the
// handedness above all, or bumps become dents.
TEST(SharedScenes, GeneratedTangentsAgreeWithTheFilesOwn) {
    const std::filesystem::path path = folder() / "khronos_flight_helmet" / "khronos_flight_helmet.glb";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << missing(path);
    const Scene scene = loadGltf(path);
    std::vector<Vertex> vertices = scene.vertices;
    for (const Mesh& mesh : scene.meshes)
        generateTangents(std::span(vertices).subspan(mesh.firstVertex, mesh.vertexCount),
                         std::span(scene.indices).subspan(mesh.firstIndex, mesh.indexCount));
    size_t sameSide = 0, close = 0;
    for (size_t i = 0; i < vertices.size(); ++i) {
        const glm::vec4 &own = scene.vertices[i].tangent, &made = vertices[i].tangent;
        sameSide += own.w == made.w;
        close += glm::dot(glm::vec3(own), glm::vec3(made)) > 0.9f;
    }
    EXPECT_GT(double(sameSide), 0.99 * double(vertices.size()));
    EXPECT_GT(double(close), 0.99 * double(vertices.size()));
}
