// Mip levels of a texture, filtered by a box in linear light.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <vector>

namespace harness {

struct MipLevel {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgba;
};

struct MipOptions {
    bool isNormalMap = false; // vectors are normalised again
    // Alpha-test threshold of the texture; 0: none. Each level keeps the share of level 0 that passes, because foliage
    // would thin out with distance otherwise. Colours are weighted by alpha.
    float alphaCutoff = 0;
};

// Returns the levels from the full size down to 1x1. Throws std::runtime_error if the texture's size is 0 or does not
// fit its bytes.
std::vector<MipLevel> makeMipChain(const Texture& texture, const MipOptions& options);

// Returns the texture at other sizes, which are powers of two. Levels of `source` that exist at a size are kept, so
// that levels of equal detail look alike. Larger levels are interpolated.
std::vector<MipLevel> resizeMipChain(const std::vector<MipLevel>& levels, const Texture& source, uint32_t width,
                                     uint32_t height);

// Returns how the scene's materials use each texture.
std::vector<MipOptions> mipOptions(const Scene& scene);

} // namespace harness
