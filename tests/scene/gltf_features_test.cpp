// Features of glTF that the loader resolves when it reads a file, and the sentences for those that it drops.
#include "gltf_file.h"
#include "render/lights.h"
#include "scene_support.h"

#include <limits>
#include <sys/stat.h>

using namespace harness;
using namespace scene_test;

namespace {

const std::vector<float> kCorners{0, 0, 1, 0, 0, 1, 1, 1}; // texture coordinates of the square

glm::dvec3 worldPosition(const Scene& scene, const Instance& instance, size_t vertex) {
    const Vertex& v = scene.vertices[scene.meshes[instance.mesh].firstVertex + vertex];
    return glm::dvec3(instance.transform * glm::dvec4(v.position, 1));
}

bool drops(const Scene& scene, const std::string& part) {
    return std::count_if(scene.dropped.begin(), scene.dropped.end(), [&](const std::string& sentence) {
               return sentence.find(part) != std::string::npos && sentence.back() == '.';
           }) == 1;
}

// A square with two sets of texture coordinates, the second of which is 0.5 times the first. `textures` are the members
// of its material.
Scene squareWithTextures(const std::string& material, const std::string& more = "") {
    GltfFile file;
    const std::string attributes =
        R"("attributes":{"POSITION":)" + str(file.add(kSquare, "VEC3", kFloat)) + R"(,"NORMAL":)" +
        str(file.add(kSquareNormals, "VEC3", kFloat)) + R"(,"TEXCOORD_0":)" + str(file.add(kCorners, "VEC2", kFloat)) +
        R"(,"TEXCOORD_1":)" + str(file.add(std::vector<float>{0, 0, 0.5f, 0, 0, 0.5f, 0.5f, 0.5f}, "VEC2", kFloat)) +
        "}";
    return loadGltf(file.writeGlb("coordinates", oneNode(R"("mode":5,"material":0,)" + attributes) +
                                                     R"(,"images":[{"mimeType":"image/png","bufferView":)" +
                                                     str(file.addView(kPng)) +
                                                     R"(}],"textures":[{"source":0,"sampler":0}],"materials":[{)" +
                                                     material + "}]" + (more.empty() ? R"(,"samplers":[{}])" : more)));
}

std::string baseColor(const std::string& more) {
    return R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0)" + more + "}}";
}

std::string transformed(const std::string& members) {
    return R"(,"extensions":{"KHR_texture_transform":{)" + members + "}}";
}

} // namespace

TEST(GltfFeatures, MaterialChoosesTheTextureCoordinates) {
    EXPECT_EQ(squareWithTextures(baseColor("")).vertices[3].uv, glm::vec2(1, 1));
    EXPECT_EQ(squareWithTextures(baseColor(R"(,"texCoord":1)")).vertices[3].uv, glm::vec2(0.5f, 0.5f));
    EXPECT_EQ(squareWithTextures(baseColor(transformed(R"("texCoord":1)"))).vertices[3].uv, glm::vec2(0.5f, 0.5f));
    EXPECT_EQ(squareWithTextures(baseColor(transformed(R"("offset":[0.25,0],"scale":[0.5,2])"))).vertices[3].uv,
              glm::vec2(0.75f, 2));
    EXPECT_EQ(squareWithTextures(baseColor(R"(,"texCoord":2)")).vertices[3].uv, glm::vec2(0));
}

// The example of the extension: "only the lower left quadrant of the source image", turned by 90 degrees.
TEST(GltfFeatures, TextureTransformsTurnCounterClockwise) {
    const Scene scene =
        squareWithTextures(baseColor(transformed(R"("offset":[0,1],"rotation":1.57079632679,"scale":[0.5,0.5])")));
    const glm::vec2 expected[] = {{0, 1}, {0, 0.5f}, {0.5f, 1}, {0.5f, 0.5f}};
    for (size_t i = 0; i < 4; ++i)
        EXPECT_LT(glm::length(scene.vertices[i].uv - expected[i]), 1e-6f) << i;
}

TEST(GltfFeatures, OneMaterialHasOnePairOfCoordinates) {
    const std::string moved = R"("emissiveTexture":{"index":0,"texCoord":1})";
    EXPECT_TRUE(squareWithTextures(moved).dropped.empty());
    const Scene scene = squareWithTextures(baseColor("") + "," + moved);
    EXPECT_EQ(scene.vertices[3].uv, glm::vec2(1, 1));
    EXPECT_TRUE(drops(scene, "coordinates of its first texture"));
}

TEST(GltfFeatures, SamplersFilter) {
    const auto filters = [](const std::string& sampler) {
        return squareWithTextures(baseColor(""), R"(,"samplers":[{)" + sampler + "}]").textures.at(0).filters;
    };
    EXPECT_EQ(filters(""), TextureFilters{});
    EXPECT_EQ(filters(R"("magFilter":9729,"minFilter":9987)"), TextureFilters{});
    EXPECT_EQ(filters(R"("magFilter":9728)"), (TextureFilters{Filter::Nearest, Filter::Linear, MipFilter::Linear}));
    EXPECT_EQ(filters(R"("minFilter":9728)"), (TextureFilters{Filter::Linear, Filter::Nearest, MipFilter::None}));
    EXPECT_EQ(filters(R"("minFilter":9729)"), (TextureFilters{Filter::Linear, Filter::Linear, MipFilter::None}));
    EXPECT_EQ(filters(R"("minFilter":9984)"), (TextureFilters{Filter::Linear, Filter::Nearest, MipFilter::Nearest}));
    EXPECT_EQ(filters(R"("minFilter":9985)"), (TextureFilters{Filter::Linear, Filter::Linear, MipFilter::Nearest}));
    EXPECT_EQ(filters(R"("minFilter":9986)"), (TextureFilters{Filter::Linear, Filter::Nearest, MipFilter::Linear}));
    EXPECT_EQ(filters(R"("minFilter":7)"), TextureFilters{});
}

// Weights of the mesh hold for nodes that have none. Flat normals are those of the morphed triangles.
TEST(GltfFeatures, DefaultMorphWeightsAreApplied) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const int moved = file.add(std::vector<float>{1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3", kFloat);
    const int folded = file.add(std::vector<float>{0, 0, 0, 0, 0, 0, 0, -1, 1, 0, -1, 1}, "VEC3", kFloat);
    const Scene scene = loadGltf(file.writeGlb(
        "morph", R"("meshes":[{"weights":[2,0],"primitives":[{"mode":5,"attributes":{"POSITION":)" + str(position) +
                     R"(},"targets":[{"POSITION":)" + str(moved) + R"(},{"POSITION":)" + str(folded) +
                     R"(,"COLOR_0":)" + str(moved) +
                     R"(}]}]}],"nodes":[{"mesh":0},{"mesh":0,"weights":[0.5,1]},{"mesh":0,"weights":[2,0]}],)"
                     R"("scenes":[{"nodes":[0,1,2]}])"));
    ASSERT_EQ(scene.instances.size(), 3u);
    expectNear(worldPosition(scene, scene.instances[0], 0), {2, 0, 0});
    expectNear(worldPosition(scene, scene.instances[1], 0), {0.5, 0, 0});
    expectNear(scene.vertices[scene.meshes[scene.instances[1].mesh].firstVertex].normal, {0, -1, 0});
    EXPECT_EQ(scene.instances[0].mesh, scene.instances[2].mesh);
    EXPECT_TRUE(drops(scene, "morph targets"));
}

// The joints place a skinned mesh, and its own node does not.
TEST(GltfFeatures, SkinnedMeshesStandInTheirPose) {
    GltfFile file;
    const std::string attributes =
        R"("mode":5,"attributes":{"POSITION":)" + str(file.add(kSquare, "VEC3", kFloat)) + R"(,"NORMAL":)" +
        str(file.add(kSquareNormals, "VEC3", kFloat)) + R"(,"JOINTS_0":)" +
        str(file.add(std::vector<uint8_t>{0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4", kByte)) +
        R"(,"WEIGHTS_0":)" +
        str(file.add(std::vector<float>{1, 0, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}, "VEC4", kFloat)) + "}";
    // The first joint is bound at x = 1.
    const int bind = file.add(std::vector<float>{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1, //
                                                 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  0, 0, 1},
                              "MAT4", kFloat);
    const std::string skins = R"(,"skins":[{"joints":[2,1],"inverseBindMatrices":)" + str(bind) + "}]";
    const std::string nodes =
        R"("nodes":[{"mesh":0,"skin":0,"translation":[7,7,7]},{"rotation":[0.70710678118654752,0,0,)"
        R"(0.70710678118654752]},{"translation":[1,0,5]}],"scenes":[{"nodes":[0,1,2]}])";
    const Scene scene =
        loadGltf(file.writeGlb("skin", R"("meshes":[{"primitives":[{)" + attributes + "}]}]," + nodes + skins));
    const Instance& instance = scene.instances.at(0);
    expectNear(worldPosition(scene, instance, 0), {0, 0, 5});   // the first joint moves by 5
    expectNear(worldPosition(scene, instance, 1), {1, 0, 2.5}); // both joints
    expectNear(worldPosition(scene, instance, 2), {0, 0, 1});   // the second joint turns y to z
    expectNear(scene.vertices[2].normal, {0, -1, 0});
    expectNear(worldPosition(scene, instance, 3), {1, 1, 0}); // a vertex without weights stays
    expectError(file.writeGlb("joint", R"("meshes":[{"primitives":[{)" + attributes + "}]}]," + nodes +
                                           R"(,"skins":[{"joints":[2]}])"),
                "joint");
}

TEST(GltfFeatures, DroppedFeaturesAreNamed) {
    GltfFile file;
    const std::string position = R"("attributes":{"POSITION":)" + str(file.add(kSquare, "VEC3", kFloat)) + "}";
    std::string primitives;
    for (const char* mode : {"0", "1", "2", "3", "5"})
        primitives += (primitives.empty() ? "{" : ",{") + position + R"(,"mode":)" + mode + "}";
    const Scene scene = loadGltf(file.writeGlb(
        "dropped", R"("extensionsUsed":["KHR_materials_sheen","KHR_lights_punctual"],"animations":[{"channels":[],)"
                   R"("samplers":[]}],"materials":[{"occlusionTexture":{"index":0}}],"cameras":[{"type":"perspective",)"
                   R"("perspective":{"yfov":0,"znear":1}}],"meshes":[{"primitives":[)" +
                       primitives + R"(]}],"nodes":[{"mesh":0,"camera":0}],"scenes":[{"nodes":[0]}])"));
    EXPECT_EQ(scene.placedTriangles(), 2u);
    EXPECT_TRUE(scene.cameras.empty());
    for (const char* part : {"points", "lines", "animations", "occlusion", "KHR_materials_sheen", "camera"})
        EXPECT_TRUE(drops(scene, part)) << part;
    EXPECT_EQ(scene.dropped.size(), 6u);
}

// A lamp that reaches far is not large.
TEST(GltfFeatures, RadiusOfALampDoesNotDependOnItsRange) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const auto radius = [&](const std::string& range, const std::string& scale) {
        const Scene scene = loadGltf(file.writeGlb(
            "lamp", R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point")" + range +
                        R"(}]}},"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":)" + str(position) +
                        R"(}}]}],"nodes":[{"mesh":0,"scale":)" + scale +
                        R"(},{"extensions":{"KHR_lights_punctual":{"light":0}}}],"scenes":[{"nodes":[0,1]}])"));
        return toAgaaLights(scene.lights, {}, {}).at(0).radius;
    };
    for (const char* range : {"", R"(,"range":1000)", R"(,"range":0.01)"}) {
        EXPECT_FLOAT_EQ(radius(range, "[100,100,100]"), 0.01f) << range;
        EXPECT_FLOAT_EQ(radius(range, "[0.1,0.1,0.1]"), 0.0001f * std::sqrt(2.0f)) << range;
    }
}

// Floats far from their origin have coarse steps, which matrices of floats would enlarge.
TEST(GltfFeatures, FarVerticesHaveTheirOwnOrigin) {
    GltfFile file;
    const int position = file.add(std::vector<float>{100000, 0, 0, 100001, 0, 0, 100000, 1, 0}, "VEC3", kFloat);
    const Scene scene = loadGltf(file.writeGlb("far", oneNode(R"("attributes":{"POSITION":)" + str(position) + "}")));
    for (const Vertex& v : scene.vertices)
        EXPECT_LE(glm::length(v.position), 1);
    expectNear(worldPosition(scene, scene.instances[0], 1), {100001, 0, 0}, 1e-9);
    expectNear(scene.boundsMax, {100001, 1, 0}, 1e-9);
}

// A directory has 2^63 - 1 bytes for tinygltf; a pipe would make it wait.
TEST(GltfFeatures, BuffersAreRegularFiles) {
    const std::filesystem::path& folder = scratchFolder();
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const std::string& uri :
         {std::string("."), std::string("\\u0000"), std::string("x/.."), std::string("\\u0000:x"),
          std::string("/dev/zero"), std::string("pipe"), std::string()}) {
        std::ofstream(folder / "no_file.gltf")
            << R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":42,"uri":")" << uri << R"("}]})";
        expectError(folder / "no_file.gltf", uri.empty() ? "uri" : "not found");
    }
}

TEST(GltfFeatures, IndicesOfLightsAreIndices) {
    GltfFile file;
    file.add(kCorners, "VEC2", kFloat);
    for (const char* index : {"1e38", "-1e38", "1", "-1", "2147483648", "\"0\""})
        expectError(file.writeGlb("lamp_index", R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}},)"
                                                R"("nodes":[{"extensions":{"KHR_lights_punctual":{"light":)" +
                                                    std::string(index) + R"(}}}],"scenes":[{"nodes":[0]}])"),
                    "lights");
}

// Every number of a file is finite in the scene, or one sentence refuses the file.
TEST(GltfFeatures, NumbersOutOfRangeAreContained) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    GltfFile file;
    const std::string attributes =
        R"("mode":5,"attributes":{"POSITION":)" +
        str(file.add(std::vector<float>{nan, 0, 0, inf, 0, 0, 0, 3e38f, 0, 1, -3e38f, 0}, "VEC3", kFloat)) +
        R"(,"TEXCOORD_0":)" + str(file.add(std::vector<float>{nan, inf, 3e38f, -3e38f, 0, 0, 0, 0}, "VEC2", kFloat)) +
        "}";
    const std::string lights =
        R"(,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":1e300,"range":-1e300,)"
        R"("color":[-1,1e300,1],"spot":{"innerConeAngle":9,"outerConeAngle":-9}}]}})";
    const std::string material =
        R"(,"materials":[{"emissiveFactor":[1e300,-1,0],"alphaMode":"MASK","alphaCutoff":1e300,"pbrMetallicRoughness":)"
        R"({"baseColorFactor":[-1,1e300,2,1],"roughnessFactor":1e300,"metallicFactor":-1e300}}])";
    const auto load = [&](const std::string& node) {
        return file.writeGlb("hostile",
                             R"("meshes":[{"weights":[1e300],"primitives":[{"material":0,)" + attributes +
                                 R"(}]}],"nodes":[{"mesh":0,"extensions":{"KHR_lights_punctual":{"light":0}},)" + node +
                                 R"(}],"scenes":[{"nodes":[0]}])" + material + lights);
    };
    const Scene scene = loadGltf(load(R"("rotation":[0,0,0,0])"));
    expectWellFormed(scene);
    EXPECT_TRUE(drops(scene, "not finite"));
    const Light& light = scene.lights.at(0);
    for (int c = 0; c < 3; ++c)
        EXPECT_TRUE(light.color[c] >= 0 && std::isfinite(light.color[c]));
    EXPECT_TRUE(light.range >= 0 && light.innerCone <= light.outerCone && light.outerCone >= 0);
    const Material& m = scene.materials.at(0);
    EXPECT_EQ(m.baseColor, glm::vec4(0, 1, 1, 1));
    EXPECT_EQ(m.roughness, 1);
    EXPECT_EQ(m.metallic, 0);
    EXPECT_TRUE(std::isfinite(m.alphaCutoff));
    EXPECT_EQ(m.emissive, glm::vec3(65504, 0, 0));
    expectError(load(R"("scale":[1e300,1,1],"translation":[1e300,0,0])"), "transform");
    expectError(load(R"("matrix":[1e308,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])"), "transform");
}
