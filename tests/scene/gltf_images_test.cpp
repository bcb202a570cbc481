// Files and images that a glTF file names: which of them the loader needs, and what it reports of them.
#include "gltf_file.h"
#include "render/host_material.h"

#include <iterator>

using namespace harness;
using namespace scene_test;

namespace {

const std::vector<uint8_t> kNoImage{'n', 'o', ' ', 'i', 'm', 'a', 'g', 'e', '!', '!', '!', '!'};

// A square whose base colour is texture 0. The images lie in the buffer; `rest` has textures and what else there is.
std::filesystem::path squareWith(const std::string& stem, const std::vector<std::vector<uint8_t>>& images,
                                 const std::string& rest) {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    std::string list;
    for (const auto& image : images)
        list += std::string(list.empty() ? "" : ",") + R"({"name":"wood","bufferView":)" + str(file.addView(image)) +
                R"(,"mimeType":"image/png"})";
    return file.writeGlb(
        stem, oneNode(R"("mode":5,"material":0,"attributes":{"POSITION":)" + str(position) + "}") + R"(,"images":[)" +
                  list + R"(],"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)" + rest);
}

std::filesystem::path squareWithUri(const std::string& uri, const std::string& bufferUri = "") {
    GltfFile file;
    const int position = file.add(kSquare, "VEC3", kFloat);
    const std::string rest = oneNode(R"("mode":5,"material":0,"attributes":{"POSITION":)" + str(position) + "}") +
                             R"(,"images":[{"uri":")" + uri +
                             R"("}],"textures":[{"source":0}],"materials":[{"emissiveTexture":{"index":0}}])";
    // Tests run side by side.
    const std::string stem = std::string("uris-") + testing::UnitTest::GetInstance()->current_test_info()->name();
    if (bufferUri.empty())
        return file.writeGltf(stem, rest);
    const std::filesystem::path path = scratchFolder() / (stem + ".gltf");
    GltfFile::write(path, file.json(rest, bufferUri));
    return path;
}

} // namespace

// Formats of optional extensions, and images that no material shows, need not be readable.
TEST(GltfImages, OnlyThoseThatMaterialsShowAreDecoded) {
    EXPECT_EQ(loadGltf(squareWith("unused", {kNoImage, kPng}, R"("textures":[{"source":1}])")).textures.size(), 1u);
    EXPECT_EQ(loadGltf(squareWith("fallback", {kPng, kNoImage},
                                  R"("extensionsUsed":["EXT_texture_webp"],)"
                                  R"("textures":[{"source":0,"extensions":{"EXT_texture_webp":{"source":1}}}])"))
                  .textures.size(),
              1u);
    // No primitive has the material.
    EXPECT_TRUE(loadGltf(squareWith("material", {kNoImage},
                                    R"("textures":[{"source":0}],"meshes":[],"nodes":[{}],"scenes":[{"nodes":[0]}])"))
                    .textures.empty());
    expectError(squareWith("used", {kNoImage}, R"("textures":[{"source":0}])"),
                R"(the image "wood" could not be decoded)");
}

TEST(GltfImages, TextureWithoutAReadableImageIsWhite) {
    const Scene scene = loadGltf(squareWith("optional", {kNoImage},
                                            R"("extensionsUsed":["EXT_texture_webp"],)"
                                            R"("textures":[{"extensions":{"EXT_texture_webp":{"source":0}}}])"));
    EXPECT_EQ(scene.materials.at(0).baseColorTexture, -1);
}

TEST(GltfImages, MissingFileIsCalledMissing) {
    expectError(squareWithUri("absent.png"), R"(the image file "absent.png" is missing or empty)");
    GltfFile::write(scratchFolder() / "text.png", "no image");
    expectError(squareWithUri("text.png"), R"(the image "text.png" could not be decoded)");
}

// A plus sign in a URI is a plus sign; only percent signs escape.
TEST(GltfImages, PlusIsACharacterOfFileNames) {
    const std::filesystem::path& folder = scratchFolder();
    GltfFile::write(folder / "a+b c.png", {kPng.begin(), kPng.end()});
    GltfFile file;
    file.add(kSquare, "VEC3", kFloat);
    GltfFile::write(folder / "x+y.bin", {file.bytes.begin(), file.bytes.end()});
    EXPECT_EQ(loadGltf(squareWithUri("a+b%20c.png", "x+y.bin")).textures.size(), 1u);
    expectError(squareWithUri("no+file.png"), R"("no+file.png" is missing)");
}

TEST(GltfImages, ErrorsAreShort) {
    const std::string megabyte(1 << 20, '*');
    expectError(squareWithUri("a.png", "data:application/octet-stream;base64," + megabyte), "data:application");
    expectError(squareWithUri("data:image/webp;base64," + megabyte), "data:image/webp");
    expectError(squareWithUri(megabyte + ".png"), "missing");
    expectError(squareWithUri(R"(line\nbreak\u0007.png)"), "line");
    const std::filesystem::path path = scratchFolder() / "unterminated.gltf";
    GltfFile::write(path, R"({"asset":{"version":"2.0"},"buffers":[{"uri":"data:)" + megabyte);
    expectError(path, "not a readable glTF file");
}

// A file that needs an extension is often unreadable without it.
TEST(GltfImages, RequiredExtensionIsNamedFirst) {
    GltfFile file;
    const std::string rest = R"("extensionsRequired":["EXT_meshopt_compression"],"accessors":[{"count":"many"}],)" +
                             oneNode(R"("indices":7,"attributes":{"POSITION":8})");
    expectError(file.writeGltf("required", rest), "EXT_meshopt_compression");
    expectError(
        squareWith("webp", {kNoImage}, R"("extensionsRequired":["EXT_texture_webp"],"textures":[{"source":0}])"),
        "EXT_texture_webp");
}

TEST(GltfImages, ExtensionOfFileMayBeUppercase) {
    const std::filesystem::path path = squareWith("upper", {kPng}, R"("textures":[{"source":0}])");
    const std::filesystem::path upper = scratchFolder() / "UPPER.GLB";
    std::filesystem::rename(path, upper);
    EXPECT_EQ(loadScene(upper.string()).textures.size(), 1u);
}

// Sizes of chunks are not trusted, and nested values do not exhaust the stack.
TEST(GltfImages, ContainerIsChecked) {
    const std::filesystem::path& folder = scratchFolder();
    const std::filesystem::path path = squareWith("chunks", {kPng}, R"("textures":[{"source":0}])");
    std::ifstream in(path, std::ios::binary);
    const std::string whole(std::istreambuf_iterator<char>(in), {});
    for (size_t size : {4u, 12u, 19u, 23u}) {
        GltfFile::write(folder / "cut.glb", whole.substr(0, size));
        expectError(folder / "cut.glb", "not a readable glTF file");
    }
    // The last chunk is cut by its own header.
    GltfFile::write(folder / "cut.glb", whole.substr(0, whole.size() - 8));
    expectError(folder / "cut.glb", "a chunk is longer than the file");
    GltfFile::write(folder / "deep.gltf", R"({"asset":{"version":"2.0"},"extras":)" + std::string(1000000, '[') +
                                              std::string(1000000, ']') + "}");
    expectError(folder / "deep.gltf", "nested");
}

TEST(GltfImages, TooLargeTextureIsNamed) {
    const Scene scene = loadGltf(squareWith("large", {kPng}, R"("textures":[{"source":0}])")); // 1 x 2
    checkTextureSizes(scene, 2);
    try {
        checkTextureSizes(scene, 1);
        ADD_FAILURE() << "accepted";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), R"(The texture "wood" of the scene "large" has 1x2 texels; the device allows 1x1.)");
    }
}
