// A scene as the SDK's pass that fetches by id reads it (shaders/fetch.glsl): draws and materials for buffers, textures
// in the layers of arrays.
#pragma once

#include "render/host_material.h"
#include "render/texture_arrays.h"

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

// wraps: of the textures, 2 bits of u and 2 of v: 0 repeat, 1 mirror, 2 clamp; then 4 bits each of TextureLayer's
// repeatsU and repeatsV.
struct FetchMaterial {
    MaterialConstants values;
    glm::ivec4 layers;
    glm::uvec4 wraps;
};
static_assert(sizeof(FetchMaterial) == 80);

struct FetchVertex {
    glm::vec3 position;
    glm::u8vec4 color; // a: 255 where the tangent's handedness is 1, else 0
    glm::vec3 normal;
    float u;
    glm::vec3 tangent;
    float v;
};
static_assert(sizeof(FetchVertex) == 48);

struct FetchScene {
    std::vector<FetchVertex> vertices;    // as Scene::vertices, one at least
    std::vector<FetchMaterial> materials; // as Scene::materials, then the default one
    TextureArrays colors;                 // sRGB
    TextureArrays values;
    uint32_t maxDraws = 1;
    uint32_t maxPrimitives = 1;
};
FetchScene makeFetchScene(const Scene& scene);

// draws: as they are drawn, which is how ids count them.
std::vector<FetchDraw> fetchDraws(const Scene& scene, const std::vector<Draw>& draws);

// For AgaaFetchFunction::glsl; without the textures that no material of the scene has.
std::string fetchGlsl(const FetchScene& fetch, bool openGl);

} // namespace harness
