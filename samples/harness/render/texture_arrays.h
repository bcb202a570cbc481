// Textures of one colour space as layers of arrays: two, by size, where in one the small ones would
// take much of its memory.
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
inline constexpr int firstSmallLayer =
    4096; // also in shaders/fetch.glsl; devices have 2048 layers, seldom more

// used: indices into Scene::textures; options: of all of them.
TextureArrays makeTextureArrays(const Scene& scene, const std::set<int>& used,
                                const std::vector<MipOptions>& options);

} // namespace harness
