// A scene as the SDK's pass that fetches by id reads it (shaders/fetch.glsl): draws and materials for buffers, textures
// resized to the layers of two arrays.
#pragma once

#include "render/host_material.h"
#include "render/mip_chain.h"

#include <string>

namespace harness {

struct FetchDraw {
    std::array<glm::vec4, 3> toShading;
    std::array<glm::vec4, 3> normalToShading;
    uint32_t firstIndex;
    uint32_t firstVertex;
    uint32_t material;
    float handedness;
};
static_assert(sizeof(FetchDraw) == 112);

struct FetchMaterial {
    MaterialConstants values;
    glm::ivec4 layers;
    glm::uvec4 wraps;
};
static_assert(sizeof(FetchMaterial) == 80);

// Of one size; never none, since a sampler must have something to read.
using TextureLayers = std::vector<std::vector<MipLevel>>;

struct FetchScene {
    std::vector<FetchMaterial> materials; // as Scene::materials, then the default one
    TextureLayers colors;                 // sRGB
    TextureLayers values;
    uint32_t maxDraws = 1;
    uint32_t maxPrimitives = 1;
};
FetchScene makeFetchScene(const Scene& scene);

// draws: as they are drawn, which is how ids count them.
std::vector<FetchDraw> fetchDraws(const Scene& scene, const std::vector<Draw>& draws);

// For AgaaFetchFunction::glsl.
std::string fetchGlsl(bool openGl);

} // namespace harness
