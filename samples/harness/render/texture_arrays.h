// Textures of one colour space as layers of arrays. There is one array, or two by size if that saves a quarter of the
// memory. A texture that is smaller than its layer is repeated in it, so that each level filters like the level of the
// single texture.
#pragma once

#include "render/mip_chain.h"

#include <map>
#include <set>

namespace harness {

// Layers of one size; at least one, because a sampler must have something to read.
using TextureLayers = std::vector<std::vector<MipLevel>>;

struct TextureLayer {
    int layer = -1;                      // small textures have layers from firstSmallLayer on
    uint32_t repeatsU = 0, repeatsV = 0; // log2 of the repetitions of the texture in the layer
};

struct TextureArrays {
    TextureLayers large;
    TextureLayers small;
    bool isSplit = false;               // false: `small` holds no texture of the scene
    std::map<int, TextureLayer> layers; // key: index into Scene::textures

    TextureLayer layerOf(int texture) const { return texture < 0 ? TextureLayer{} : layers.at(texture); }
};
inline constexpr int firstSmallLayer = 1 << 20; // above the layer limit of all devices

// `used` holds indices into Scene::textures; `options` has one element for each texture there.
TextureArrays makeTextureArrays(const Scene& scene, const std::set<int>& used, const std::vector<MipOptions>& options);

} // namespace harness
