#include "render/texture_arrays.h"

#include <algorithm>
#include <bit>

namespace harness {

namespace {

constexpr uint32_t largestLayer = 1024;
constexpr double leastSaving = 0.25; // share of one array's memory that is worth a second sampler

struct Size {
    uint32_t width = 1, height = 1;

    uint32_t side() const { return std::max(width, height); }
    uint64_t texels() const { return uint64_t(width) * height; }
};

uint32_t layerSide(uint32_t size) {
    return std::min(std::bit_ceil(size), largestLayer);
}

Size layerSize(const Texture& texture) {
    return {layerSide(texture.width), layerSide(texture.height)};
}

// Textures by whether both their sides are at most `side`.
struct Split {
    std::vector<int> large, small;
    Size largeSize, smallSize;

    Split(const Scene& scene, const std::set<int>& used, uint32_t side) {
        for (const int texture : used) {
            const Size size = layerSize(scene.textures[size_t(texture)]);
            const bool isSmall = size.side() <= side;
            (isSmall ? small : large).push_back(texture);
            Size& most = isSmall ? smallSize : largeSize;
            most = {std::max(most.width, size.width), std::max(most.height, size.height)};
        }
    }
    uint64_t texels() const {
        return large.size() * largeSize.texels() + small.size() * smallSize.texels();
    }
};

Split bestSplit(const Scene& scene, const std::set<int>& used) {
    const Split one(scene, used, 0);
    Split best = one;
    for (uint32_t side = 1; side < largestLayer; side *= 2)
        if (const Split split(scene, used, side); split.texels() < best.texels())
            best = split;
    return double(best.texels()) <= (1 - leastSaving) * double(one.texels()) ? best : one;
}

TextureLayers makeLayers(const Scene& scene, const std::vector<int>& textures, Size size,
                         const std::vector<MipOptions>& options) {
    TextureLayers layers;
    for (const int texture : textures) {
        const Texture& source = scene.textures[size_t(texture)];
        layers.push_back(resizeMipChain(makeMipChain(source, options[size_t(texture)]), source, size.width,
                                        size.height));
    }
    if (layers.empty())
        layers.push_back({{1, 1, {255, 255, 255, 255}}});
    return layers;
}

} // namespace

TextureArrays makeTextureArrays(const Scene& scene, const std::set<int>& used,
                                const std::vector<MipOptions>& options) {
    const Split split = bestSplit(scene, used);
    TextureArrays arrays{makeLayers(scene, split.large, split.largeSize, options),
                         makeLayers(scene, split.small, split.smallSize, options),
                         !split.small.empty(),
                         {}};
    for (size_t i = 0; i < split.large.size(); ++i)
        arrays.layers[split.large[i]] = int(i);
    for (size_t i = 0; i < split.small.size(); ++i)
        arrays.layers[split.small[i]] = firstSmallLayer + int(i);
    return arrays;
}

} // namespace harness
