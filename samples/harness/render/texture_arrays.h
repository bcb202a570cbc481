// Textures of one colour space as layers of arrays: of one, or of two by size where that saves a quarter of its memory.
// A texture smaller than its layer is repeated in it, so that each level filters as that of the texture by itself; in a
// direction in which it does not wrap around it is resized.
#pragma once

#include "render/mip_chain.h"

#include <map>
#include <set>

namespace harness {

// Of one size; never none, since a sampler must have something to read.
using TextureLayers = std::vector<std::vector<MipLevel>>;

struct TextureLayer {
    int layer = -1; // of a small texture: from firstSmallLayer on
    uint32_t repeatsU = 0, repeatsV = 0; // log2 of how often the layer has the texture
};

struct TextureArrays {
    TextureLayers large;
    TextureLayers small;
    bool isSplit = false;      // else `small` holds nothing of the scene's
    std::map<int, TextureLayer> layers; // by index into Scene::textures

    TextureLayer layerOf(int texture) const { return texture < 0 ? TextureLayer{} : layers.at(texture); }
};
inline constexpr int firstSmallLayer = 1 << 20; // beyond the layers of any device

// used: indices into Scene::textures; options: one of each texture there.
TextureArrays makeTextureArrays(const Scene& scene, const std::set<int>& used,
                                const std::vector<MipOptions>& options);

} // namespace harness
