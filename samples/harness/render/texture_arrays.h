// Textures of one colour space as layers of arrays: of one, or of two by size where that saves a
// quarter of its memory.
#pragma once

#include "render/mip_chain.h"

#include <map>
#include <set>

namespace harness {

// Of one size; never none, since a sampler must have something to read.
using TextureLayers = std::vector<std::vector<MipLevel>>;

struct TextureArrays {
    TextureLayers large;
    TextureLayers small;
    bool isSplit = false;      // else `small` holds nothing of the scene's
    std::map<int, int> layers; // by index into Scene::textures; small ones from firstSmallLayer on

    int layerOf(int texture) const { return texture < 0 ? -1 : layers.at(texture); }
};
inline constexpr int firstSmallLayer = 1 << 20; // beyond the layers of any device

// used: indices into Scene::textures; options: one of each texture there.
TextureArrays makeTextureArrays(const Scene& scene, const std::set<int>& used,
                                const std::vector<MipOptions>& options);

} // namespace harness
