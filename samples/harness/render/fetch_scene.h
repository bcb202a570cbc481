// A scene for the SDK's fetching passes (shaders/fetch.glsl): draws and materials for buffers, textures in layers of
// arrays.
#pragma once

#include "render/host_material.h"
#include "render/texture_arrays.h"

#include <string>

namespace harness {

// Matches the block FetchCamera of fetch.glsl (std140).
struct FetchCamera {
    glm::mat4 viewProjection;
    glm::vec4 viewer; // CameraMatrices::viewer
};
static_assert(sizeof(FetchCamera) == 80);

struct FetchDraw {
    std::array<glm::vec4, 3> toShading;
    std::array<glm::vec4, 3> normalToShading;
    uint32_t firstIndex;
    uint32_t firstVertex;
    uint32_t material;
    float handedness;
    uint32_t primitives; // 0: the frame does not show the draw
    uint32_t flags;      // 1: both sides are drawn, 2: alpha-masked, 4: 16 alpha points, 8: tested at the cutoff
    uint32_t seed;
    float alphaCutoff;
};
static_assert(sizeof(FetchDraw) == 128);

// Each element of samplers describes a texture, from the lowest bit: 2 bits for u and 2 for v (0 repeat, 1 mirror, 2
// clamp), 4 bits each for TextureLayer::repeatsU and repeatsV, 1 bit each for magnification and minification (1
// nearest), and 2 bits for mip levels (0 linear, 1 nearest, 2 none).
struct FetchMaterial {
    MaterialConstants values;
    glm::ivec4 layers;
    glm::uvec4 samplers;
};
static_assert(sizeof(FetchMaterial) == 80);

struct FetchVertex {
    glm::vec3 position;
    glm::u8vec4 color; // a: seven bits of alpha above a bit that is 1 where the tangent's handedness is 1
    glm::vec3 normal;
    float u;
    glm::vec3 tangent;
    float v;
};
static_assert(sizeof(FetchVertex) == 48);

struct FetchScene {
    std::vector<FetchVertex> vertices;    // Scene::vertices, at least one
    std::vector<FetchMaterial> materials; // Scene::materials, then the default material
    TextureArrays colors;                 // sRGB
    TextureArrays values;
    uint32_t maxDraws = 1;
    uint32_t maxPrimitives = 1;
    uint32_t maxTriangles = 1;
};
FetchScene makeFetchScene(const Scene& scene);

// Returns a row for each instance of the scene, `draws` first. They are in the order in which they are drawn, because
// ids follow that order.
std::vector<FetchDraw> fetchDraws(const Scene& scene, const std::vector<Draw>& draws);

// Returns the text for AgaaFetchFunction::glsl, without the textures that no material of the scene uses.
std::string fetchGlsl(const FetchScene& fetch, bool openGl);

} // namespace harness
