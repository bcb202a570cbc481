#include "render/filtered_shadows.h"

#include "embedded.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace harness {

namespace {

constexpr float exponent = 20; // moments of depth 1 stay below 1e18

// The shader's block has these numbers.
static_assert(AGAA_MAX_SHADOW_LAYERS == 6 && AGAA_MAX_SHADOW_MAPS == 4);

MipLevel levelOf(const std::vector<glm::vec2>& texels, uint32_t size) {
    MipLevel level{size, size, {}};
    level.rgba.resize(texels.size() * sizeof(glm::vec2));
    std::memcpy(level.rgba.data(), texels.data(), level.rgba.size());
    return level;
}

std::vector<glm::vec2> halved(const std::vector<glm::vec2>& texels, uint32_t size) {
    std::vector<glm::vec2> result;
    for (uint32_t y = 0; y + 1 < size; y += 2)
        for (uint32_t x = 0; x + 1 < size; x += 2) {
            const glm::vec2* at = &texels[size_t(y) * size + x];
            result.push_back(0.25f * (at[0] + at[1] + at[size] + at[size + 1]));
        }
    return result;
}

} // namespace

std::vector<std::vector<MipLevel>> momentLayers(const std::vector<float>& depths, uint32_t size) {
    const size_t texels = size_t(size) * size;
    std::vector<std::vector<MipLevel>> layers(depths.size() / texels);
    for (size_t layer = 0; layer < layers.size(); ++layer) {
        std::vector<glm::vec2> moments(texels);
        for (size_t i = 0; i < texels; ++i) {
            const float warped = std::exp(exponent * depths[layer * texels + i]);
            moments[i] = {warped, warped * warped};
        }
        for (uint32_t width = size; width > 0; width /= 2) {
            layers[layer].push_back(levelOf(moments, width));
            moments = halved(moments, width);
        }
    }
    return layers;
}

FilteredShadowConstants filteredShadowConstants(const std::vector<AgaaShadow>& shadows) {
    FilteredShadowConstants constants{};
    uint32_t first = 0;
    for (size_t i = 0; i < shadows.size(); ++i) {
        FilteredShadowConstants::Shadow& to = constants.shadows[i];
        to.layers = {first, shadows[i].layerCount, 0, 0};
        to.bias.x = shadows[i].depthBias;
        std::memcpy(to.toClip, shadows[i].matrices, sizeof to.toClip);
        first += shadows[i].layerCount;
    }
    return constants;
}

std::string filteredShadowGlsl(const FilteredShadowBindings& bindings) {
    return "#define FILTERED_SHADOWS_AT " + bindings.map + "\n#define FILTERED_LIGHT_AT " + bindings.constants +
           "\n#define FILTERED_EXPONENT " + std::to_string(exponent) + "\n" + embedded::filtered_shadows_glsl;
}

std::vector<AgaaShadow> answeredByFunction(std::vector<AgaaShadow> shadows) {
    for (AgaaShadow& shadow : shadows)
        shadow.layerCount = 0;
    return shadows;
}

} // namespace harness
