// Textures in arrays by size: when there are two, and that each texture is whose layer says so.
#include "render/texture_arrays.h"

#include <gtest/gtest.h>

namespace harness {
namespace {

// One colour a texture, its number.
Scene sceneOf(const std::vector<glm::uvec2>& sizes) {
    Scene scene;
    for (const glm::uvec2& size : sizes) {
        Texture texture;
        texture.width = size.x;
        texture.height = size.y;
        texture.rgba.assign(size_t(4) * size.x * size.y, uint8_t(10 * (scene.textures.size() + 1)));
        scene.textures.push_back(texture);
    }
    return scene;
}

TextureArrays arraysOf(const Scene& scene, const std::set<int>& used) {
    return makeTextureArrays(scene, used, std::vector<MipOptions>(scene.textures.size()));
}

void expectEachIsItsLayer(const TextureArrays& arrays, const std::set<int>& used) {
    for (const int texture : used) {
        const int code = arrays.layerOf(texture).layer;
        const bool isSmall = code >= firstSmallLayer;
        const TextureLayers& array = isSmall ? arrays.small : arrays.large;
        const size_t layer = size_t(isSmall ? code - firstSmallLayer : code);
        ASSERT_LT(layer, array.size());
        EXPECT_EQ(array[layer][0].rgba[0], 10 * (texture + 1));
        EXPECT_EQ(array[layer][0].width, array[0][0].width);
        EXPECT_EQ(array[layer][0].height, array[0][0].height);
    }
}

TEST(TextureArrays, LikeSizesMakeOne) {
    const Scene scene = sceneOf({{64, 64}, {64, 32}, {64, 64}, {33, 64}, {16, 16}});
    const std::set<int> used = {0, 1, 2, 3, 4};
    const TextureArrays arrays = arraysOf(scene, used);
    EXPECT_FALSE(arrays.isSplit);
    EXPECT_EQ(arrays.large.size(), 5u);
    expectEachIsItsLayer(arrays, used);
}

TEST(TextureArrays, ManySmallOnesHaveTheirOwn) {
    const Scene scene = sceneOf({{16, 8}, {256, 128}, {8, 16}, {16, 16}, {100, 128}});
    const std::set<int> used = {0, 1, 2, 3, 4};
    const TextureArrays arrays = arraysOf(scene, used);
    EXPECT_TRUE(arrays.isSplit);
    EXPECT_EQ(arrays.large.size(), 2u);
    EXPECT_EQ(arrays.large[0][0].width, 256u);
    EXPECT_EQ(arrays.large[0][0].height, 128u);
    EXPECT_EQ(arrays.small.size(), 3u);
    EXPECT_EQ(arrays.small[0][0].width, 16u);
    EXPECT_EQ(arrays.small[0][0].height, 16u);
    expectEachIsItsLayer(arrays, used);
}

TEST(TextureArrays, TheSplitThatSavesMostIsTaken) {
    const Scene scene = sceneOf({{256, 256}, {64, 64}, {64, 64}, {64, 64}, {8, 8}, {8, 8}, {8, 8}});
    const TextureArrays arrays = arraysOf(scene, {0, 1, 2, 3, 4, 5, 6});
    EXPECT_EQ(arrays.large.size(), 1u);
    EXPECT_EQ(arrays.small[0][0].width, 64u);
}

TEST(TextureArrays, ALittleSavingMakesOne) {
    std::vector<glm::uvec2> sizes(9, {128, 128});
    sizes.insert(sizes.end(), 2, {8, 8}); // 2 of 11
    const Scene scene = sceneOf(sizes);
    EXPECT_FALSE(arraysOf(scene, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}).isSplit);
    EXPECT_TRUE(arraysOf(scene, {0, 1, 9, 10}).isSplit);
}

TEST(TextureArrays, WhatIsNotUsedHasNoLayer) {
    const Scene scene = sceneOf({{256, 256}, {4, 4}});
    const TextureArrays arrays = arraysOf(scene, {1});
    EXPECT_EQ(arrays.layerOf(-1).layer, -1);
    EXPECT_EQ(arrays.layerOf(1).layer, 0);
    EXPECT_EQ(arrays.large[0][0].width, 4u);
    const TextureArrays none = arraysOf(scene, {});
    EXPECT_EQ(none.large.size(), 1u);
    EXPECT_EQ(none.small.size(), 1u);
}

// Each level of a layer is the texture's own, repeated, so that both filter alike at every footprint.
TEST(TextureArrays, SmallerTexturesAreRepeatedInEachLevel) {
    Scene scene = sceneOf({{16, 8}, {8, 8}, {16, 8}}); // too little to save for two arrays
    Texture& small = scene.textures[1];
    for (size_t i = 0; i < small.rgba.size(); ++i)
        small.rgba[i] = uint8_t(37 * i);
    const TextureArrays arrays = arraysOf(scene, {0, 1, 2});
    const TextureLayer at = arrays.layerOf(1);
    EXPECT_EQ(at.repeatsU, 1u);
    EXPECT_EQ(at.repeatsV, 0u);
    const std::vector<MipLevel> own = makeMipChain(small, {});
    const std::vector<MipLevel>& layer = arrays.large[size_t(at.layer)];
    ASSERT_EQ(layer.size(), 5u);
    for (size_t i = 0; i < layer.size(); ++i) {
        const MipLevel& expected = own[std::min(i, own.size() - 1)];
        ASSERT_EQ(layer[i].width, arrays.large[0][i].width);
        ASSERT_EQ(layer[i].height, arrays.large[0][i].height);
        for (uint32_t y = 0; y < layer[i].height; ++y)
            for (uint32_t x = 0; x < 4 * layer[i].width; ++x)
                ASSERT_EQ(layer[i].rgba[size_t(4) * y * layer[i].width + x],
                          expected.rgba[size_t(4) * (y % expected.height) * expected.width + x % (4 * expected.width)])
                    << i << ' ' << x << ' ' << y;
    }
}

TEST(TextureArrays, LayersAreAtMost1024Wide) {
    const Scene scene = sceneOf({{2048, 16}});
    const TextureArrays arrays = arraysOf(scene, {0});
    EXPECT_EQ(arrays.large[0][0].width, 1024u);
    EXPECT_EQ(arrays.large[0][0].height, 16u);
}

} // namespace
} // namespace harness
