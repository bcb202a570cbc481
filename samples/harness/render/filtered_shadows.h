// Shadow maps that are filtered in advance, for shaders/filtered_shadows.glsl: exponential variance maps (Lauritzen and
// McCool 2008), an example for AgaaShadowFunction::footprints.
#pragma once

#include "agaa_sdk.h"
#include "render/mip_chain.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace harness {

// The uniform block of the shader, in std140. Layers of all shadows are in one texture, in the order of the shadows.
struct FilteredShadowConstants {
    struct Shadow {
        glm::uvec4 layers; // first layer, number of layers
        glm::vec4 bias;    // x: of depth
        glm::mat4 toClip[AGAA_MAX_SHADOW_LAYERS];
    } shadows[AGAA_MAX_SHADOW_MAPS];
};

// The places where a graphics API binds the texture and the block.
struct FilteredShadowBindings {
    std::string map, constants;       // layout qualifiers
    uint64_t descriptorSetLayout = 0; // AgaaShadowFunction::descriptorSetLayout
};

// Returns the levels of each layer. A texel has the first two moments of exp(exponent * depth), as two floats.
//
// depths   Of all layers, row by row, in [0, 1].
// size     Width and height of a layer, a power of two.
std::vector<std::vector<MipLevel>> momentLayers(const std::vector<float>& depths, uint32_t size);

// Returns the depths of all maps of a graphics API's ShadowMaps, one after the other.
template <class ShadowMaps> std::vector<float> depthsOf(const ShadowMaps& maps) {
    std::vector<float> depths;
    for (size_t i = 0; i < maps.shadows().size(); ++i) {
        const std::vector<float> own = maps.readDepths(i);
        depths.insert(depths.end(), own.begin(), own.end());
    }
    return depths;
}

FilteredShadowConstants filteredShadowConstants(const std::vector<AgaaShadow>& shadows);

// Returns the text for AgaaShadowFunction::glsl.
std::string filteredShadowGlsl(const FilteredShadowBindings& bindings);

// Returns the shadows as frames have them whose function answers for all of them.
std::vector<AgaaShadow> answeredByFunction(std::vector<AgaaShadow> shadows);

} // namespace harness
