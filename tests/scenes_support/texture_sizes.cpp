#include "texture_sizes.h"

#include "render/fetch_scene.h"
#include "scene/builtin/mesh_builder.h"
#include "test_scenes.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace harness::test {

namespace {

// A checkerboard of two by two.
int addTexture(Scene& scene, uint32_t width, uint32_t height, bool srgb, const glm::u8vec3& a, const glm::u8vec3& b) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    texture.srgb = srgb;
    texture.wrapU = Wrap::Clamp;
    texture.wrapV = Wrap::Mirror;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const glm::u8vec3 c = (2 * x / width + 2 * y / height) % 2 ? a : b;
            texture.rgba.insert(texture.rgba.end(), {c.r, c.g, c.b, 255});
        }
    scene.textures.push_back(texture);
    return int(scene.textures.size()) - 1;
}

struct Square {
    uint32_t width, height;
    glm::u8vec3 color;
    uint8_t roughness;
};
constexpr Square squares[] = {{128, 64, {230, 40, 40}, 60},  {8, 8, {40, 230, 40}, 120},  {16, 16, {40, 40, 230}, 180},
                              {4, 16, {230, 230, 40}, 240},  {16, 4, {40, 230, 230}, 90}, {1, 1, {230, 40, 230}, 150},
                              {16, 16, {240, 140, 20}, 210}, {2, 2, {20, 140, 240}, 30}};

// A texture whose left, right, upper and lower edges differ. The texels of a small one alternate.
Texture edgedTexture(uint32_t side, const Sampling& sampling) {
    Texture texture{"", side, side, true, sampling.wrapU, sampling.wrapV, {}, sampling.filters};
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const auto red = uint8_t(x < side / 2 ? 250 : 10), blue = uint8_t(y < side / 2 ? 250 : 10);
            texture.rgba.insert(texture.rgba.end(), {red, uint8_t(side > 4 ? 90 : (x + y) % 2 ? 160 : 40), blue, 255});
        }
    return texture;
}

// Adds rows of squares that emit their textures, which are magnified in the first row and ever smaller in the others.
// Texture coordinates reach beyond the edges.
void addSamplers(Scene& scene) {
    constexpr auto linear = Filter::Linear, nearest = Filter::Nearest;
    constexpr TextureFilters initial{};
    const Sampling samplings[] = {{Wrap::Clamp, Wrap::Clamp, initial},
                                  {Wrap::Mirror, Wrap::Mirror, initial},
                                  {Wrap::Clamp, Wrap::Repeat, initial},
                                  {Wrap::Repeat, Wrap::Mirror, initial},
                                  {Wrap::Repeat, Wrap::Repeat, {nearest, nearest, MipFilter::None}},
                                  {Wrap::Clamp, Wrap::Mirror, {nearest, nearest, MipFilter::Nearest}},
                                  {Wrap::Clamp, Wrap::Clamp, {linear, linear, MipFilter::None}},
                                  {Wrap::Clamp, Wrap::Repeat, {nearest, linear, MipFilter::Linear}},
                                  {Wrap::Repeat, Wrap::Clamp, {linear, nearest, MipFilter::Linear}}};
    constexpr struct {
        uint32_t side;
        float y;
    } rows[] = {{4, 1.5f}, {32, 0.5f}, {128, -1.5f}, {256, -2.5f}};
    for (const auto& row : rows)
        for (size_t i = 0; i < std::size(samplings); ++i) {
            builtin::MeshBuilder mesh;
            mesh.quad({float(i) - 4, row.y, 0}, {0.9f, 0, 0}, {0, 0.9f, 0});
            for (Vertex& vertex : mesh.vertices)
                vertex.uv = vertex.uv * 2.2f - 0.6f;
            Material& material = builtin::addMaterial(scene, "square", 0x000000, 1, 0);
            material.emissive = {1, 1, 1};
            material.emissiveTexture = int(scene.textures.size());
            scene.textures.push_back(edgedTexture(row.side, samplings[i]));
            builtin::place(scene, builtin::addMesh(scene, mesh, builtin::lastMaterial(scene)));
        }
}

// A row of squares, each with colours and values of its own; the first has large textures, the others small ones. Other
// rows have samplers of their own.
Scene sceneOfTextureSizes() {
    Scene scene;
    scene.name = "texture sizes";
    for (size_t i = 0; i < std::size(squares); ++i) {
        const Square& square = squares[i];
        builtin::MeshBuilder mesh;
        mesh.quad({float(i) - 4, -0.5f, 0}, {0.9f, 0, 0}, {0, 0.9f, 0});
        Material& material = builtin::addMaterial(scene, "square", 0xFFFFFF, 1, 1);
        material.baseColorTexture =
            addTexture(scene, square.width, square.height, true, square.color, square.color / uint8_t(2));
        material.metalRoughTexture =
            addTexture(scene, square.width, square.height, false, {0, square.roughness, 0}, {0, square.roughness, 255});
        if (i == 2) {
            material.emissiveTexture = material.baseColorTexture;
            material.emissive = {0.3f, 0.3f, 0.3f};
        }
        builtin::place(scene, builtin::addMesh(scene, mesh, builtin::lastMaterial(scene)));
    }
    addSamplers(scene);
    updateBounds(scene);
    return scene;
}

} // namespace

void expectTextureSizesAgree(Renderer& renderer) {
    const Scene scene = sceneOfTextureSizes();
    const FetchScene fetch = makeFetchScene(scene);
    ASSERT_TRUE(fetch.colors.isSplit && fetch.values.isSplit);
    renderer.load(scene);
    TestScene test{scene.name, "", {}, true};
    test.camera.eye = {0.3, 0.4, 4.5};
    test.camera.target = {0, 0, 0};
    RenderSettings settings = settingsFor(test, scene, 192, 108);
    settings.config.technique = "agaa";
    settings.config.samples = 4; // one material per pixel in both tiers
    settings.config.aggregates = 2;
    settings.config.generationTier = AGAA_TIER_GBUFFER;
    const Image bound = renderer.render(settings).image;
    settings.config.generationTier = AGAA_TIER_IDS;
    const RenderResult byId = renderer.render(settings);
    expectEverySampleOnce(byId.statistics.back().counters);
    const double mean = meanDifference(bound, byId.image);
    const double far = shareAbove(bound, byId.image, 24.0 / 255);
    std::printf("texture sizes: mean difference %.3f/255, above 24/255 %.3f %%\n", 255 * mean, 100 * far);
    EXPECT_LT(mean, 0.4 / 255); // by id, the point of a material differs where triangles cover a part of a pixel
    EXPECT_LT(far, 0.01);
}

} // namespace harness::test
