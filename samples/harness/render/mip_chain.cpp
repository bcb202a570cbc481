#include "render/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace harness {

namespace {

struct FloatLevel {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::vec4> texels;
};

float srgbToLinear(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }

float linearToSrgb(float v) { return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f; }

uint8_t toByte(float v) { return uint8_t(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f); }

const std::array<float, 256>& decodeTable() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (size_t i = 0; i < t.size(); ++i)
            t[i] = srgbToLinear(float(i) / 255);
        return t;
    }();
    return table;
}

// The table is fine enough: at the steepest part of the curve, 12.92 at 0, an entry is a fifth of a code.
constexpr size_t encodeSize = 16384;
const std::array<uint8_t, encodeSize + 1>& encodeTable() {
    static const std::array<uint8_t, encodeSize + 1> table = [] {
        std::array<uint8_t, encodeSize + 1> t{};
        for (size_t i = 0; i < t.size(); ++i)
            t[i] = toByte(linearToSrgb(float(i) / encodeSize));
        return t;
    }();
    return table;
}

uint8_t encodeSrgb(float v) { return encodeTable()[size_t(std::clamp(v, 0.0f, 1.0f) * encodeSize + 0.5f)]; }

FloatLevel decode(const Texture& texture) {
    FloatLevel level{texture.width, texture.height, {}};
    level.texels.resize(size_t(texture.width) * texture.height);
    const auto& table = decodeTable();
    for (size_t i = 0; i < level.texels.size(); ++i) {
        const uint8_t* in = &texture.rgba[i * 4];
        if (texture.srgb)
            level.texels[i] = {table[in[0]], table[in[1]], table[in[2]], float(in[3]) / 255};
        else
            level.texels[i] = glm::vec4(in[0], in[1], in[2], in[3]) / 255.0f;
    }
    return level;
}

// If a size is odd, the last row or column of the level above contributes to the last texel by the share that the box
// covers.
struct Taps {
    std::array<uint32_t, 3> index{};
    std::array<float, 3> weight{};
    int count = 0;
};

Taps boxTaps(uint32_t out, uint32_t outSize, uint32_t inSize) {
    const double scale = double(inSize) / outSize;
    const double begin = out * scale;
    const double end = begin + scale;
    Taps taps;
    for (uint32_t i = uint32_t(begin); i < inSize && double(i) < end && taps.count < 3; ++i) {
        const double covered = std::min(end, i + 1.0) - std::max(begin, double(i));
        if (covered <= 0)
            continue;
        taps.index[size_t(taps.count)] = i;
        taps.weight[size_t(taps.count)] = float(covered / scale);
        ++taps.count;
    }
    return taps;
}

std::vector<Taps> rowTaps(uint32_t outSize, uint32_t inSize) {
    std::vector<Taps> taps;
    for (uint32_t i = 0; i < outSize; ++i)
        taps.push_back(boxTaps(i, outSize, inSize));
    return taps;
}

FloatLevel halve(const FloatLevel& in, bool weightByAlpha) {
    FloatLevel out{std::max(in.width / 2, 1u), std::max(in.height / 2, 1u), {}};
    out.texels.resize(size_t(out.width) * out.height);
    const std::vector<Taps> columns = rowTaps(out.width, in.width);
    for (uint32_t y = 0; y < out.height; ++y) {
        const Taps rows = boxTaps(y, out.height, in.height);
        for (uint32_t x = 0; x < out.width; ++x) {
            const Taps& column = columns[x];
            glm::vec4 sum(0);
            glm::vec3 weighted(0);
            for (size_t j = 0; j < size_t(rows.count); ++j) {
                for (size_t i = 0; i < size_t(column.count); ++i) {
                    const glm::vec4& texel = in.texels[size_t(rows.index[j]) * in.width + column.index[i]];
                    const float weight = rows.weight[j] * column.weight[i];
                    sum += weight * texel;
                    weighted += weight * texel.a * glm::vec3(texel);
                }
            }
            if (weightByAlpha && sum.a > 1e-4f)
                sum = glm::vec4(weighted / sum.a, sum.a);
            out.texels[size_t(y) * out.width + x] = sum;
        }
    }
    return out;
}

// Returns the share of a level's area that passes the alpha test. Alpha is multiplied by `scale`, clamped to 1 per
// texel, and filtered bilinearly. The test runs at evenly spaced points; small levels have more points per texel.
double passingShare(const FloatLevel& level, const Texture& source, float scale, float cutoff) {
    const uint32_t side = level.texels.size() > 4096 ? 4 : 8;
    const auto wrapped = [](uint32_t i, uint32_t size, Wrap wrap) { // i is the index of the texel plus 1
        if (wrap == Wrap::Repeat)
            return (i + size - 1) % size;
        return std::clamp(i, 1u, size) - 1; // a mirrored texture repeats the texel at the edge
    };
    const auto alpha = [&](uint32_t x, uint32_t y) {
        const size_t row = wrapped(y, level.height, source.wrapV);
        return std::min(scale * level.texels[row * level.width + wrapped(x, level.width, source.wrapU)].a, 1.0f);
    };
    uint64_t passing = 0;
    for (uint32_t j = 0; j <= level.height; ++j)
        for (uint32_t i = 0; i <= level.width; ++i) {
            const float a = alpha(i, j), b = alpha(i + 1, j), c = alpha(i, j + 1), d = alpha(i + 1, j + 1);
            // Points lie between texel centres; the first and the last interval of a row or column have half of them.
            const uint32_t beginX = i == 0 ? side / 2 : 0, endX = i == level.width ? side / 2 : side;
            const uint32_t beginY = j == 0 ? side / 2 : 0, endY = j == level.height ? side / 2 : side;
            if (std::max({a, b, c, d}) < cutoff)
                continue;
            for (uint32_t y = beginY; y < endY; ++y)
                for (uint32_t x = beginX; x < endX; ++x) {
                    const float u = (float(x) + 0.5f) / float(side), v = (float(y) + 0.5f) / float(side);
                    passing += std::lerp(std::lerp(a, b, u), std::lerp(c, d, u), v) >= cutoff;
                }
        }
    return double(passing) / (double(side) * side * double(level.texels.size()));
}

// Returns the scale of alpha with which the share `wanted` of the level passes the test. It is 1 if no scale comes
// nearer: small levels have few values.
float alphaScale(const FloatLevel& level, const Texture& source, float cutoff, double wanted) {
    const auto share = [&](float scale) { return passingShare(level, source, scale, cutoff); };
    float low = cutoff / 2, high = 16;
    for (int step = 0; step < 12; ++step) {
        const float middle = std::sqrt(low * high);
        (share(middle) < wanted ? low : high) = middle;
    }
    const float nearest = std::abs(share(low) - wanted) < std::abs(share(high) - wanted) ? low : high;
    return std::abs(share(1) - wanted) <= std::abs(share(nearest) - wanted) ? 1.0f : nearest;
}

MipLevel encode(const FloatLevel& level, bool srgb, const MipOptions& options, float alpha) {
    MipLevel out{level.width, level.height, {}};
    out.rgba.resize(level.texels.size() * 4);
    for (size_t i = 0; i < level.texels.size(); ++i) {
        glm::vec3 color(level.texels[i]);
        if (options.isNormalMap) {
            const glm::vec3 normal = color * 2.0f - 1.0f;
            const float length = glm::length(normal);
            color = (length > 1e-4f ? normal / length : glm::vec3(0, 0, 1)) * 0.5f + 0.5f;
        }
        for (int c = 0; c < 3; ++c)
            out.rgba[i * 4 + size_t(c)] = srgb ? encodeSrgb(color[c]) : toByte(color[c]);
        out.rgba[i * 4 + 3] = toByte(level.texels[i].a * alpha);
    }
    return out;
}

} // namespace

std::vector<MipLevel> makeMipChain(const Texture& texture, const MipOptions& options) {
    if (texture.width == 0 || texture.height == 0 || texture.rgba.size() != size_t(texture.width) * texture.height * 4)
        throw std::runtime_error("The size of the texture \"" + texture.name + "\" is 0 or does not fit its bytes.");
    std::vector<MipLevel> levels;
    levels.push_back({texture.width, texture.height, texture.rgba});

    const bool isTested = options.alphaCutoff > 0;
    FloatLevel level = decode(texture);
    const double wanted = isTested ? passingShare(level, texture, 1, options.alphaCutoff) : 0;
    while (level.width > 1 || level.height > 1) {
        level = halve(level, isTested);
        // If nothing or everything passes, no scale is better than another.
        const bool isScaled = isTested && wanted > 0 && wanted < 1;
        const float alpha = isScaled ? alphaScale(level, texture, options.alphaCutoff, wanted) : 1.0f;
        levels.push_back(encode(level, texture.srgb, options, alpha));
    }
    return levels;
}

namespace {

// Interpolates between texel centres. A texel beyond the edge is the wrapped one, or with mirroring and clamping the
// texel at the edge.
glm::vec4 interpolated(const FloatLevel& level, const Texture& source, double x, double y) {
    const auto wrapped = [](double v, uint32_t size, Wrap wrap) {
        const auto i = int64_t(std::floor(v)), count = int64_t(size);
        return size_t(wrap == Wrap::Repeat ? (i % count + count) % count : std::clamp<int64_t>(i, 0, count - 1));
    };
    const size_t x0 = wrapped(x, level.width, source.wrapU), x1 = wrapped(x + 1, level.width, source.wrapU);
    const size_t y0 = wrapped(y, level.height, source.wrapV), y1 = wrapped(y + 1, level.height, source.wrapV);
    const auto fx = float(x - std::floor(x)), fy = float(y - std::floor(y));
    const auto at = [&](size_t i, size_t j) { return level.texels[j * level.width + i]; };
    return glm::mix(glm::mix(at(x0, y0), at(x1, y0), fx), glm::mix(at(x0, y1), at(x1, y1), fx), fy);
}

FloatLevel resized(const FloatLevel& level, const Texture& source, uint32_t width, uint32_t height) {
    FloatLevel out{width, height, {}};
    out.texels.reserve(size_t(width) * height);
    const Filter filter = width > level.width || height > level.height ? source.filters.magnify : source.filters.minify;
    if (filter == Filter::Nearest) {
        for (uint64_t y = 0; y < height; ++y)
            for (uint64_t x = 0; x < width; ++x)
                out.texels.push_back(level.texels[size_t((2 * y + 1) * level.height / (2 * height) * level.width +
                                                         (2 * x + 1) * level.width / (2 * width))]);
        return out;
    }
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            out.texels.push_back(interpolated(level, source, (x + 0.5) * level.width / width - 0.5,
                                              (y + 0.5) * level.height / height - 0.5));
    return out;
}

} // namespace

std::vector<MipLevel> resizeMipChain(const std::vector<MipLevel>& levels, const Texture& source, uint32_t width,
                                     uint32_t height) {
    std::vector<MipLevel> out;
    size_t nearest = 0; // the smallest level that is not smaller than wanted, or the largest
    for (;; width = std::max(width / 2, 1u), height = std::max(height / 2, 1u)) {
        while (nearest + 1 < levels.size() && levels[nearest + 1].width >= width &&
               levels[nearest + 1].height >= height)
            ++nearest;
        const MipLevel& level = levels[nearest];
        if (level.width == width && level.height == height) {
            out.push_back(level);
        } else {
            const Texture texture{"",           level.width,  level.height, source.srgb,
                                  source.wrapU, source.wrapV, level.rgba,   source.filters};
            out.push_back(encode(resized(decode(texture), source, width, height), source.srgb, {}, 1));
        }
        if (width == 1 && height == 1)
            return out;
    }
}

std::vector<MipOptions> mipOptions(const Scene& scene) {
    std::vector<MipOptions> options(scene.textures.size());
    const auto find = [&](int texture) {
        return texture >= 0 && size_t(texture) < options.size() ? &options[size_t(texture)] : nullptr;
    };
    for (const Material& material : scene.materials) {
        if (MipOptions* normal = find(material.normalTexture))
            normal->isNormalMap = true;
        MipOptions* base = find(material.baseColorTexture);
        if (base && material.alphaMode == AlphaMode::Mask && material.baseColor.a > 0 && base->alphaCutoff <= 0)
            base->alphaCutoff = std::max(material.alphaCutoff / material.baseColor.a, 1.0f / 255);
    }
    return options;
}

} // namespace harness
