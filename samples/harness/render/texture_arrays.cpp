#include "render/texture_arrays.h"

#include <algorithm>
#include <bit>

namespace harness {

namespace {

constexpr uint32_t largestLayer = 1024;
constexpr double minSaving = 0.25; // share of one array's memory that justifies a second sampler

struct Size {
    uint32_t width = 1, height = 1;

    uint32_t side() const { return std::max(width, height); }
    uint64_t texels() const { return uint64_t(width) * height; }
};

uint32_t layerSide(uint32_t size) { return std::min(std::bit_ceil(size), largestLayer); }

Size layerSize(const Texture& texture) { return {layerSide(texture.width), layerSide(texture.height)}; }

// Splits textures by whether both sides are at most `side`.
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
    uint64_t texels() const { return large.size() * largeSize.texels() + small.size() * smallSize.texels(); }
};

Split bestSplit(const Scene& scene, const std::set<int>& used) {
    const Split one(scene, used, 0);
    Split best = one;
    for (uint32_t side = 1; side < largestLayer; side *= 2)
        if (const Split split(scene, used, side); split.texels() < best.texels())
            best = split;
    return double(best.texels()) <= (1 - minSaving) * double(one.texels()) ? best : one;
}

uint32_t levelSide(uint32_t side, size_t level) { return std::max(side >> level, 1u); }

// Returns a layer of `size` in which each level repeats the level of the texture.
std::vector<MipLevel> repeated(const std::vector<MipLevel>& levels, Size size) {
    std::vector<MipLevel> out;
    for (size_t i = 0; i < size_t(std::bit_width(size.side())); ++i) {
        const MipLevel& level = levels[std::min(i, levels.size() - 1)];
        MipLevel& layer = out.emplace_back();
        layer.width = levelSide(size.width, i);
        layer.height = levelSide(size.height, i);
        layer.rgba.reserve(size_t(4) * layer.width * layer.height);
        for (uint32_t y = 0; y < layer.height; ++y) {
            const auto row = level.rgba.begin() + ptrdiff_t(4) * (y % level.height) * level.width;
            for (uint32_t x = 0; x < layer.width; x += level.width)
                layer.rgba.insert(layer.rgba.end(), row, row + ptrdiff_t(4) * level.width);
        }
    }
    return out;
}

TextureLayers makeLayers(const Scene& scene, const std::vector<int>& textures, Size size,
                         const std::vector<MipOptions>& options) {
    TextureLayers layers;
    for (const int texture : textures) {
        const Texture& source = scene.textures[size_t(texture)];
        const Size own = layerSize(source);
        layers.push_back(repeated(
            resizeMipChain(makeMipChain(source, options[size_t(texture)]), source, own.width, own.height), size));
    }
    if (layers.empty())
        layers.push_back({{1, 1, {255, 255, 255, 255}}});
    return layers;
}

} // namespace

TextureArrays makeTextureArrays(const Scene& scene, const std::set<int>& used, const std::vector<MipOptions>& options) {
    const Split split = bestSplit(scene, used);
    TextureArrays arrays{makeLayers(scene, split.large, split.largeSize, options),
                         makeLayers(scene, split.small, split.smallSize, options),
                         !split.small.empty(),
                         {}};
    const auto place = [&](const std::vector<int>& textures, Size size, int firstLayer) {
        for (size_t i = 0; i < textures.size(); ++i) {
            const Size own = layerSize(scene.textures[size_t(textures[i])]);
            arrays.layers[textures[i]] = {firstLayer + int(i), uint32_t(std::countr_zero(size.width / own.width)),
                                          uint32_t(std::countr_zero(size.height / own.height))};
        }
    };
    place(split.large, split.largeSize, 0);
    place(split.small, split.smallSize, firstSmallLayer);
    return arrays;
}

} // namespace harness
