#include "environment/sphere_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace harness {

namespace {

constexpr double pi = std::numbers::pi;
constexpr float brightest = 1e9f;
constexpr uint32_t minWidth = 128; // texels of smaller images would be large against the cosine

// Texels of one axis that a texel of the smaller image covers, with their weights, whose sum is 1.
struct Cover {
    uint32_t first = 0;
    std::vector<double> weights;
};

// Boundaries increase: those of the smaller image are a subset of the range of those of the larger one.
std::vector<Cover> coversOf(const std::vector<double>& from, const std::vector<double>& to) {
    std::vector<Cover> covers;
    for (size_t i = 0; i + 1 < to.size(); ++i) {
        Cover cover;
        for (size_t k = 0; k + 1 < from.size(); ++k) {
            const double overlap = std::min(from[k + 1], to[i + 1]) - std::max(from[k], to[i]);
            if (overlap <= 0)
                continue;
            if (cover.weights.empty())
                cover.first = uint32_t(k);
            cover.weights.push_back(overlap / (to[i + 1] - to[i]));
        }
        covers.push_back(std::move(cover));
    }
    return covers;
}

std::vector<double> columns(uint32_t count) {
    std::vector<double> boundaries;
    for (uint32_t x = 0; x <= count; ++x)
        boundaries.push_back(double(x) / count);
    return boundaries;
}

// Solid angle is proportional to the difference of cosines.
std::vector<double> rows(uint32_t count) {
    std::vector<double> boundaries;
    for (uint32_t y = 0; y <= count; ++y)
        boundaries.push_back(-std::cos(pi * y / count));
    return boundaries;
}

SphereImage resized(const SphereImage& image, uint32_t width) {
    SphereImage result{width, width / 2, {}};
    const std::vector<Cover> across = coversOf(columns(image.width), columns(result.width));
    const std::vector<Cover> down = coversOf(rows(image.height), rows(result.height));
    for (const Cover& row : down)
        for (const Cover& column : across) {
            glm::dvec3 sum(0);
            for (size_t j = 0; j < row.weights.size(); ++j)
                for (size_t i = 0; i < column.weights.size(); ++i)
                    sum += row.weights[j] * column.weights[i] *
                           glm::dvec3(image.at(column.first + uint32_t(i), row.first + uint32_t(j)));
            result.texels.emplace_back(sum);
        }
    return result;
}

} // namespace

glm::dvec3 sphereDirection(double longitude, double colatitude) {
    const double across = std::sin(colatitude);
    return {across * std::sin(longitude), std::cos(colatitude), -across * std::cos(longitude)};
}

glm::vec3 SphereImage::directionOf(uint32_t x, uint32_t y) const {
    return glm::vec3(sphereDirection(2 * pi * ((x + 0.5) / width - 0.5), pi * (y + 0.5) / height));
}

double SphereImage::solidAngle(uint32_t y) const {
    return 2 * pi / width * (std::cos(pi * y / height) - std::cos(pi * (y + 1.0) / height));
}

glm::vec2 spherePlace(const glm::vec3& direction) {
    constexpr float inverse = std::numbers::inv_pi_v<float>;
    return {0.5f + 0.5f * inverse * std::atan2(direction.x, -direction.z),
            inverse * std::acos(std::clamp(direction.y, -1.0f, 1.0f))};
}

glm::vec3 SphereImage::lookup(const glm::vec2& place) const {
    const float x = place.x * float(width) - 0.5f, y = place.y * float(height) - 0.5f;
    const int left = int(std::floor(x)), top = int(std::floor(y));
    const float right = x - float(left), lower = y - float(top);
    const auto texel = [this](int column, int row) {
        const bool isAcross = row < 0 || row >= int(height); // beyond a pole lies the opposite meridian
        row = row < 0 ? 0 : std::min(row, int(height) - 1);
        column += isAcross ? int(width / 2) : 0;
        return at(uint32_t(column + 2 * int(width)) % width, uint32_t(row));
    };
    return (1 - lower) * ((1 - right) * texel(left, top) + right * texel(left + 1, top)) +
           lower * ((1 - right) * texel(left, top + 1) + right * texel(left + 1, top + 1));
}

SphereImage makeSphereImage(const Image& image, uint32_t maxWidth, uint64_t& replaced) {
    SphereImage source{image.width, image.height, {}};
    replaced = 0;
    for (size_t i = 0; i < image.pixelCount(); ++i) {
        glm::vec3 radiance;
        for (int c = 0; c < 3; ++c) {
            const float value = image.rgb[3 * i + size_t(c)];
            radiance[c] = std::isfinite(value) ? std::clamp(value, 0.0f, brightest) : 0.0f;
            replaced += radiance[c] != value;
        }
        source.texels.push_back(radiance);
    }
    return resized(source, std::clamp(std::bit_floor(source.width), minWidth, maxWidth));
}

SphereImage halved(const SphereImage& image) { return resized(image, image.width / 2); }

} // namespace harness
