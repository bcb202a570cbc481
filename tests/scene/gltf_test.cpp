#include "gltf_file.h"
#include "scene/gltf.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace harness;
using namespace scene_test;

namespace {

// The signed area of a mesh's triangles about +z, in object space.
double areaAboutZ(const Scene& scene, const Mesh& mesh) {
    double area = 0;
    for (uint32_t i = 0; i < mesh.indexCount; i += 3) {
        glm::vec3 p[3];
        for (uint32_t c = 0; c < 3; ++c)
            p[c] = scene.vertices[mesh.firstVertex + scene.indices[mesh.firstIndex + i + c]].position;
        area += 0.5 * glm::cross(p[1] - p[0], p[2] - p[0]).z;
    }
    return area;
}

} // namespace

TEST(Gltf, StripsFansListsAndAllIndexTypesGiveTheSameSquare) {
    GltfFile file;
    const std::string position = R"("attributes":{"POSITION":)" + str(file.add(kSquare, "VEC3", kFloat)) + "}";
    const int bytes = file.add(std::vector<uint8_t>{0, 1, 2, 3}, "SCALAR", kByte);
    const int shorts = file.add(std::vector<uint16_t>{0, 1, 3, 2}, "SCALAR", kShort);
    const int ints = file.add(std::vector<uint32_t>{0, 1, 2, 2, 1, 3}, "SCALAR", kInt);
    const std::string primitives = "{" + position + R"(,"mode":5},{)" + position + R"(,"mode":5,"indices":)" +
                                   str(bytes) + "},{" + position + R"(,"mode":6,"indices":)" + str(shorts) + "},{" +
                                   position + R"(,"indices":)" + str(ints) + "}";
    const Scene scene = loadGltf(file.writeGlb("modes", R"("meshes":[{"primitives":[)" + primitives +
                                                            R"(]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])"));
    ASSERT_EQ(scene.meshes.size(), 4u);
    EXPECT_EQ(scene.placedTriangles(), 8u);
    for (const Mesh& mesh : scene.meshes) {
        EXPECT_EQ(mesh.indexCount, 6u);
        EXPECT_DOUBLE_EQ(areaAboutZ(scene, mesh), 1.0);
    }
    for (const Vertex& vertex : scene.vertices) // generated
        expectNear(vertex.normal, {0, 0, 1});
}

// Vertices without normals are those of flat triangles, and their tangents are ignored.
TEST(Gltf, TrianglesWithoutNormalsAreFlat) {
    // Two triangles, facing +z and -x, share the vertices 0 and 2. The third has no area.
    GltfFile file;
    const int position = file.add(std::vector<float>{0, 0, 0, 3, 0, 0, 0, 1, 0, 0, 0, -1}, "VEC3", kFloat);
    const int tangent = file.add(std::vector<float>{0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, "VEC4", kFloat);
    const int indices = file.add(std::vector<uint8_t>{0, 1, 2, 0, 2, 3, 1, 1, 2}, "SCALAR", kByte);
    const Scene scene =
        loadGltf(file.writeGltf("normals", oneNode(R"("attributes":{"POSITION":)" + str(position) + R"(,"TANGENT":)" +
                                                   str(tangent) + R"(},"indices":)" + str(indices))));
    ASSERT_EQ(scene.vertices.size(), 9u);
    ASSERT_EQ(scene.meshes.at(0).indexCount, 9u);
    for (size_t i = 0; i < 3; ++i) {
        expectNear(scene.vertices[i].normal, {0, 0, 1});
        expectNear(scene.vertices[3 + i].normal, {-1, 0, 0});
        expectNear(scene.vertices[6 + i].normal, {0, 1, 0});
        expectNear(glm::vec3(scene.vertices[i].tangent), {1, 0, 0});
    }
}

TEST(Gltf, NodesMultiplyAndShareMeshes) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const std::string rest =
        R"("meshes":[{"primitives":[{"attributes":{"POSITION":)" + str(position) +
        R"(},"mode":5}]}],"nodes":[)"
        R"({"translation":[1000000,2,3],"rotation":[0,0.70710678118654752,0,0.70710678118654752],"scale":[2,2,2],"children":[1,2]},)"
        R"({"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0.25,0,0,1]},)"
        R"({"mesh":0,"scale":[-1,1,1]}],"scenes":[{"nodes":[]},{"nodes":[0]}],"scene":1)";
    const Scene scene = loadGltf(file.writeGltf("hierarchy", rest));
    ASSERT_EQ(scene.meshes.size(), 1u);
    ASSERT_EQ(scene.instances.size(), 2u);
    // A quarter turn about +y takes +x to -z.
    expectNear(glm::dvec3(scene.instances[0].transform * glm::dvec4(1, 0, 0, 1)), {1000000, 2, 3 - 2.5});
    expectNear(glm::dvec3(scene.instances[1].transform * glm::dvec4(1, 1, 0, 1)), {1000000, 4, 3 + 2});
    EXPECT_LT(glm::determinant(glm::dmat3(scene.instances[1].transform)), 0);
    expectNear(scene.boundsMin, {1000000, 2, 0.5}, 1e-5);
    expectNear(scene.boundsMax, {1000000, 4, 5}, 1e-5);
}

TEST(Gltf, ColoursAndTextureCoordinatesMayBeNormalisedIntegers) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const int bytes =
        file.add(std::vector<uint8_t>{255, 0, 51, 255, 1, 2, 3, 4, 0, 0, 0, 0, 9, 9, 9, 9}, "VEC4", kByte, true);
    const int floats = file.add(std::vector<float>{2, -1, 0.5f, 0, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC3", kFloat);
    const int uv = file.add(std::vector<uint16_t>{0, 65535, 65535, 0, 0, 0, 13107, 0}, "VEC2", kShort, true);
    const int normal = file.add(kSquareNormals, "VEC3", kFloat);
    const std::string common = R"({"mode":5,"attributes":{"POSITION":)" + str(position) + R"(,"NORMAL":)" +
                               str(normal) + R"(,"TEXCOORD_0":)" + str(uv) + R"(,"COLOR_0":)";
    const Scene scene =
        loadGltf(file.writeGltf("colours", R"("meshes":[{"primitives":[)" + common + str(bytes) + "}}," + common +
                                               str(floats) + R"(}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])"));
    EXPECT_EQ(scene.vertices[0].color, glm::u8vec4(255, 0, 51, 255));
    EXPECT_EQ(scene.vertices[1].color, glm::u8vec4(1, 2, 3, 4));
    EXPECT_EQ(scene.vertices[4].color, glm::u8vec4(255, 0, 128, 255)); // clamped, alpha 1
    EXPECT_EQ(scene.vertices[0].uv, glm::vec2(0, 1));
    EXPECT_FLOAT_EQ(scene.vertices[3].uv.x, 0.2f);
}

TEST(Gltf, TexturesAreSharedByImageWrapAndColourSpace) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const int image = file.addView(kPng);
    const std::string primitive = R"({"mode":5,"attributes":{"POSITION":)" + str(position) + R"(},"material":)";
    const std::string rest =
        R"("meshes":[{"primitives":[)" + primitive + "0}," + primitive +
        R"(1}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"images":[{"mimeType":"image/png","bufferView":)" +
        str(image) +
        R"(}],"samplers":[{},{"wrapS":33071,"wrapT":33648}],)"
        R"("textures":[{"source":0},{"source":0,"sampler":0},{"source":0,"sampler":1}],"materials":[)"
        R"({"name":"a","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,0.75],"roughnessFactor":0.3,)"
        R"("baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}},)"
        R"("normalTexture":{"index":1,"scale":0.5},"emissiveTexture":{"index":1},)"
        R"("emissiveFactor":[1,0.5,0],"alphaMode":"MASK","alphaCutoff":0.25,"doubleSided":true,)"
        R"("extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}}},)"
        R"({"alphaMode":"BLEND","emissiveTexture":{"index":2}}])";
    const Scene scene = loadGltf(file.writeGlb("textures", rest));
    ASSERT_EQ(scene.textures.size(), 3u);
    const Material& a = scene.materials.at(0);
    EXPECT_EQ(a.name, "a");
    EXPECT_EQ(a.baseColor, glm::vec4(0.5f, 0.25f, 1, 0.75f));
    EXPECT_EQ(a.emissive, glm::vec3(4, 2, 0));
    EXPECT_FLOAT_EQ(a.metallic, 1);
    EXPECT_FLOAT_EQ(a.roughness, 0.3f);
    EXPECT_FLOAT_EQ(a.normalScale, 0.5f);
    EXPECT_EQ(a.alphaMode, AlphaMode::Mask);
    EXPECT_FLOAT_EQ(a.alphaCutoff, 0.25f);
    EXPECT_TRUE(a.doubleSided);
    EXPECT_EQ(a.emissiveTexture, a.baseColorTexture);
    EXPECT_EQ(a.metalRoughTexture, a.normalTexture);
    EXPECT_NE(a.normalTexture, a.baseColorTexture);
    const Texture& color = scene.textures[size_t(a.baseColorTexture)];
    EXPECT_TRUE(color.srgb);
    EXPECT_FALSE(scene.textures[size_t(a.normalTexture)].srgb);
    EXPECT_EQ(color.width, 1u);
    EXPECT_EQ(color.height, 2u);
    EXPECT_EQ(color.rgba, (std::vector<uint8_t>{255, 0, 0, 255, 0, 0, 0, 0}));
    const Material& b = scene.materials.at(1);
    EXPECT_EQ(b.alphaMode, AlphaMode::Blend);
    EXPECT_EQ(scene.textures[size_t(b.emissiveTexture)].wrapU, Wrap::Clamp);
    EXPECT_EQ(scene.textures[size_t(b.emissiveTexture)].wrapV, Wrap::Mirror);
}

// A strength that no float holds is as bright as half floats can be, in the same hue.
TEST(Gltf, InfiniteEmissionIsTheBrightest) {
    GltfFile file;
    const int p = file.add(kSquare, "VEC3", kFloat);
    for (const char* strength : {"1e39", "1e9", "1e300"}) {
        const Scene scene = loadGltf(file.writeGltf(
            "bright", oneNode(R"("mode":5,"material":0,"attributes":{"POSITION":)" + str(p) + "}") +
                          R"(,"extensionsUsed":["KHR_materials_emissive_strength"],"materials":[{)"
                          R"("emissiveFactor":[1,0.5,0],"extensions":{"KHR_materials_emissive_strength":)"
                          R"({"emissiveStrength":)" +
                          strength + "}}}]"));
        EXPECT_EQ(scene.materials[0].emissive, glm::vec3(65504, 32752, 0)) << strength;
    }
}

TEST(Gltf, TangentsAreGeneratedForNormalMaps) {
    GltfFile file;
    const std::string attributes = R"("attributes":{"POSITION":)" + str(file.add(kSquare, "VEC3", kFloat)) +
                                   R"(,"NORMAL":)" + str(file.add(kSquareNormals, "VEC3", kFloat));
    // u along +y; the mirrored copy has v along -x of the other; the last has no uv area at all.
    const std::vector<std::vector<float>> uvs{
        {0, 0, 0, 1, 1, 0, 1, 1}, {0, 1, 0, 0, 1, 1, 1, 0}, {0, 0, 0, 0, 0, 0, 0, 0}};
    std::string primitives;
    for (const auto& uv : uvs)
        primitives += std::string(primitives.empty() ? "" : ",") + R"({"mode":5,"material":0,)" + attributes +
                      R"(,"TEXCOORD_0":)" + str(file.add(uv, "VEC2", kFloat)) + "}}";
    // A file's own tangents: not unit, not across the normal, none at all.
    const int own = file.add(std::vector<float>{2, 0, 2, -1, 0, 3, 0, 1, 0, 0, 0, 1, 0, 0, 5, 1}, "VEC4", kFloat);
    primitives += R"(,{"mode":5,"material":0,)" + attributes + R"(,"TANGENT":)" + str(own) + "}}";
    const int image = file.addView(kPng);
    const Scene scene = loadGltf(file.writeGlb(
        "tangents",
        R"("meshes":[{"primitives":[)" + primitives +
            R"(]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}],"images":[{"mimeType":"image/png","bufferView":)" +
            str(image) + R"(}],"textures":[{"source":0}],"materials":[{"normalTexture":{"index":0}}])"));
    for (size_t i = 0; i < scene.vertices.size(); ++i) {
        const Vertex& v = scene.vertices[i];
        EXPECT_NEAR(glm::length(glm::vec3(v.tangent)), 1, 1e-6) << i;
        EXPECT_NEAR(glm::dot(glm::vec3(v.tangent), v.normal), 0, 1e-6) << i;
        EXPECT_EQ(std::fabs(v.tangent.w), 1) << i;
    }
    for (size_t i = 0; i < 8; ++i)
        expectNear(glm::vec3(scene.vertices[i].tangent), {0, 1, 0});
    // cross(normal, tangent) * w points against v: with n = +z and t = +y the product is -x, while
    // v grows along +x in the first copy.
    EXPECT_EQ(scene.vertices[0].tangent.w, 1);
    EXPECT_EQ(scene.vertices[4].tangent.w, -1);
    expectNear(glm::vec3(scene.vertices[12].tangent), {1, 0, 0});
    EXPECT_EQ(scene.vertices[12].tangent.w, -1);
    expectNear(glm::vec3(scene.vertices[13].tangent), {0, 1, 0});
}

TEST(Gltf, LightsAndCamerasFollowTheirNodes) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const std::string rest =
        R"("extensionsUsed":["KHR_lights_punctual"],"meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":)" +
        str(position) +
        R"(}}]}],"cameras":[{"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"zfar":9,"znear":1}},)"
        R"({"type":"perspective","name":"view","perspective":{"yfov":0.7853981633974483,"znear":0.1}}],)"
        R"("extensions":{"KHR_lights_punctual":{"lights":[)"
        R"({"type":"directional","color":[1,0.5,0.25],"intensity":3},{"type":"directional"},)"
        R"({"type":"point","intensity":20,"range":7},)"
        R"({"type":"spot","spot":{"innerConeAngle":0.1,"outerConeAngle":0.4}}]}},"nodes":[)"
        // Turned about +x by -90 degrees: what looked along -z looks along -y.
        R"({"rotation":[-0.70710678118654752,0,0,0.70710678118654752],"scale":[3,3,3],"translation":[0.5,10,0],"children":[1,2,3,4,5,6]},)"
        R"({"extensions":{"KHR_lights_punctual":{"light":0}}},{"extensions":{"KHR_lights_punctual":{"light":1}}},)"
        R"({"translation":[1,0,0],"extensions":{"KHR_lights_punctual":{"light":2}}},{"extensions":{"KHR_lights_punctual":{"light":3}}},)"
        R"({"camera":1},{"camera":0},{"mesh":0}],"scenes":[{"nodes":[0,7]}])";
    const Scene scene = loadGltf(file.writeGlb("lights", rest));
    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_EQ(scene.lights[0].type, LightType::Directional);
    EXPECT_EQ(scene.lights[0].color, glm::vec3(3, 1.5f, 0.75f));
    expectNear(scene.lights[0].direction, {0, -1, 0});
    EXPECT_TRUE(scene.lights[0].castsShadow);
    EXPECT_FALSE(scene.lights[1].castsShadow);
    EXPECT_EQ(scene.lights[2].type, LightType::Point);
    expectNear(scene.lights[2].position, {3.5, 10, 0});
    EXPECT_FLOAT_EQ(scene.lights[2].range, 7);
    EXPECT_EQ(scene.lights[2].color, glm::vec3(20));
    EXPECT_EQ(scene.lights[3].type, LightType::Spot);
    EXPECT_FLOAT_EQ(scene.lights[3].innerCone, 0.1f);
    EXPECT_FLOAT_EQ(scene.lights[3].outerCone, 0.4f);
    ASSERT_EQ(scene.cameras.size(), 2u);
    EXPECT_DOUBLE_EQ(scene.cameras[1].height, 2);
    const Camera& camera = scene.cameras[0];
    EXPECT_EQ(camera.name, "view");
    EXPECT_EQ(camera.height, 0);
    expectNear(camera.eye, {0.5, 10, 0});
    expectNear(camera.target, {0.5, 0.5, 0}); // at the depth of the bounds' middle
    expectNear(camera.up, {0, 0, -1});
    EXPECT_NEAR(camera.fovDegrees, 45, 1e-9);
}

TEST(Gltf, DeeplyNestedNodesDoNotExhaustTheStack) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const int depth = 50000;
    std::string nodes;
    for (int i = 0; i + 1 < depth; ++i)
        nodes += R"({"children":[)" + str(i + 1) + "]},";
    const Scene scene = loadGltf(
        file.writeGltf("deep", R"("meshes":[{"primitives":[{"mode":5,"attributes":{"POSITION":)" + str(position) +
                                   R"(}}]}],"nodes":[)" + nodes + R"({"mesh":0}],"scenes":[{"nodes":[0]}])"));
    EXPECT_EQ(scene.instances.size(), 1u);
}

TEST(GltfErrors, MissingOrMalformedFile) {
    const std::filesystem::path& folder = scratchFolder();
    expectError(folder / "absent.gltf", "no such file");
    GltfFile::write(folder / "empty.gltf", "");
    expectError(folder / "empty.gltf", "not a readable glTF file");
    GltfFile::write(folder / "text.gltf", "this is not JSON");
    expectError(folder / "text.gltf", "not a readable glTF file");
    GltfFile::write(folder / "noscene.gltf", R"({"asset":{"version":"2.0"}})");
    expectError(folder / "noscene.gltf", "no scene");
    GltfFile::write(folder / "short.glb", std::string("glTF\2\0\0\0\xff\xff\0\0", 12));
    expectError(folder / "short.glb", "not a readable glTF file");
    GltfFile::write(folder / "nobuffer.gltf",
                    R"({"asset":{"version":"2.0"},"buffers":[{"uri":"absent.bin","byteLength":8}]})");
    expectError(folder / "nobuffer.gltf", "absent.bin");
}

TEST(GltfErrors, IndicesOutOfRange) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const std::string attributes = R"("attributes":{"POSITION":)" + str(position) + "}";
    const int indices = file.add(std::vector<uint8_t>{0, 1, 4}, "SCALAR", kByte);
    const int uv = file.add(std::vector<float>{0, 0}, "VEC2", kFloat);
    const auto load = [&](const std::string& rest) { return file.writeGltf("range", rest); };
    expectError(load(oneNode(attributes + R"(,"indices":)" + str(indices))), "beyond the vertices");
    expectError(load(oneNode(attributes + R"(,"mode":5,"material":3)")), "material");
    expectError(load(oneNode(R"("attributes":{"POSITION":99})")), "accessors");
    expectError(
        load(oneNode(R"("mode":5,"attributes":{"POSITION":)" + str(position) + R"(,"TEXCOORD_0":)" + str(uv) + "}")),
        "TEXCOORD_0");
    expectError(load(oneNode(R"("mode":5,"attributes":{"POSITION":)" + str(uv) + "}")), "POSITION");
    expectError(load(R"("nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}])"), "meshes");
    expectError(load(R"("nodes":[{}],"scenes":[{"nodes":[1]}])"), "nodes");
    expectError(load(R"("nodes":[{"children":[0]}],"scenes":[{"nodes":[0]}])"), "tree");
    expectError(load(R"("nodes":[{}],"scenes":[{"nodes":[0]}],"scene":2)"), "scenes");
    expectError(
        load(oneNode(attributes + R"(,"mode":5,"material":0)") + R"(,"materials":[{"emissiveTexture":{"index":0}}])"),
        "textures");
    expectError(load(R"("extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[{}],"scenes":[{"nodes":[0]}])"),
                "KHR_draco_mesh_compression");
}

TEST(GltfErrors, DataBeyondTheBuffer) {
    const std::filesystem::path path = scratchFolder() / "beyond.gltf";
    GltfFile::write(scratchFolder() / "beyond.bin", std::string(64, '\0'));
    const auto write = [&](const std::string& view, const std::string& accessor, const std::string& rest) {
        GltfFile::write(path, R"({"asset":{"version":"2.0"},"buffers":[{"uri":"beyond.bin","byteLength":64}],)"
                              R"("bufferViews":[{"buffer":0,)" +
                                  view + R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3",)" +
                                  accessor + "}]," + rest + "}");
        return path;
    };
    const std::string square = oneNode(R"("attributes":{"POSITION":0})");
    const std::string beyond = "beyond its buffer";
    expectError(write(R"("byteLength":64)", R"("count":6)", square), beyond);
    expectError(write(R"("byteLength":65)", R"("count":5)", square), beyond);
    expectError(write(R"("byteLength":36,"byteOffset":32)", R"("count":3)", square), beyond);
    expectError(write(R"("byteLength":36)", R"("count":3,"byteOffset":4)", square), beyond);
    expectError(write(R"("byteLength":36)", R"("count":1537228672809129302)", square), beyond);
    expectError(write(R"("byteLength":60,"byteOffset":4},{"buffer":0,"byteLength":64,"byteOffset":32)", R"("count":5)",
                      R"("images":[{"bufferView":1,"mimeType":"image/png"}],"textures":[{"source":0}],)"
                      R"("materials":[{"emissiveTexture":{"index":0}}],)" +
                          oneNode(R"("material":0,"attributes":{"POSITION":0})")),
                "the image \"image 0\" reaches beyond its buffer");
    const auto sparse = [&](const std::string& count, const std::string& indices) {
        return write(R"("byteLength":64)",
                     R"("count":3,"sparse":{"count":)" + count + R"(,"indices":{"bufferView":0,"componentType":5125)" +
                         indices + R"(},"values":{"bufferView":0}})",
                     square);
    };
    EXPECT_EQ(loadGltf(sparse("1", "")).placedTriangles(), 1u);
    expectError(sparse("6", ""), beyond);
    std::string implied =
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":"beyond.bin","byteLength":64}],"bufferViews":)"
        R"([{"buffer":0,"byteLength":64}],"accessors":[{"componentType":5126,"type":"VEC3","count":)"
        R"(4294967296,"sparse":{"count":1,"indices":{"bufferView":0,"componentType":5125},)"
        R"("values":{"bufferView":0}}}],)";
    GltfFile::write(path, implied + square + "}");
    expectError(path, "a sparse accessor without a buffer");
    expectError(sparse("-1", ""), "invalid indices");
    expectError(sparse("1", R"(,"byteOffset":65)"), beyond);
    expectError(sparse("1", R"(,"byteOffset":-4)"), "invalid indices");
    EXPECT_EQ(loadGltf(write(R"("byteLength":60)", R"("count":5)", square)).placedTriangles(), 1u);
}

TEST(GltfErrors, NameThatIsNeitherSceneNorFile) {
    EXPECT_THROW(loadScene("bambu"), std::runtime_error);
    EXPECT_THROW(loadScene("scene.obj"), std::runtime_error);
}
