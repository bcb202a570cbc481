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
    bool isNormalMap = false; // vectors are made unit length again
    // > 0: the texture's alpha is tested against this. Each level keeps the part of level 0 that
    // passes, or foliage would thin out with distance, and colours are weighted by alpha.
    float alphaCutoff = 0;
};

// From the full size down to 1x1. Throws std::runtime_error where the texture's size is 0 or does
// not fit its bytes.
std::vector<MipLevel> makeMipChain(const Texture& texture, const MipOptions& options);

// The same texture at other sizes, which are powers of two: levels that it has at a size are taken over, so that those
// of equal detail look alike; larger ones are interpolated.
// levels: of `source`.
std::vector<MipLevel> resizeMipChain(const std::vector<MipLevel>& levels, const Texture& source, uint32_t width,
                                     uint32_t height);

// How the scene's materials use each of its textures.
std::vector<MipOptions> mipOptions(const Scene& scene);

} // namespace harness
