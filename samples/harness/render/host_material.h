// Constants of materials and draws for the sample engine's shaders (shaders/material.*).
#pragma once

#include "render/draw_list.h"

#include <array>
#include <compare>

namespace harness {

// Bindings of a material: its textures, then its constants.
constexpr uint32_t materialTextureCount = 4;
constexpr uint32_t materialConstantsBinding = 4;

// Matches the block Material of the shaders (std140).
struct MaterialConstants {
    glm::vec4 baseColor{1};
    glm::vec3 emissive{0};
    float metallic = 0;
    float roughness = 1;
    float normalScale = 1;
    float alphaCutoff = -1;
    float materialClass = 0; // classOf()
};
static_assert(sizeof(MaterialConstants) == 48);
// Returns the class by which shaders/environment.glsl chooses the reflectance of a material: 1 with a clear coat, else
// 0.
int classOf(const Material& material);
// Returns whether materials of the scene have more than one class, or one other than 0.
bool hasClasses(const Scene& scene);
MaterialConstants materialConstants(const Material& material);
// Returns indices into Scene::textures; -1 if the material has no such texture.
std::array<int, materialTextureCount> materialTextures(const Scene& scene, const Material& material);

// Returns the constant `features` of material.frag: bits of the textures in their order, then bits of the alpha test.
uint32_t materialFeatures(const Scene& scene, uint32_t material);

// Throws std::runtime_error if a mesh exceeds the scene's vertices or indices.
void checkMeshes(const Scene& scene);

// Throws std::runtime_error with the name and size of a texture that is wider or higher than `most` texels.
void checkTextureSizes(const Scene& scene, uint32_t most);

// Matches the block Camera of object.glsl and material.frag (std140).
struct CameraConstants {
    glm::mat4 viewProjection;
    glm::vec4 viewer; // CameraMatrices::viewer
    float footprint;
    float unitDistance; // of images of motion
    glm::vec2 jitter;   // CameraMatrices::jitter
};
static_assert(sizeof(CameraConstants) == 96);

// Rows of the transform from a draw's surfaces in shading space to x, y and w of the previous frame's clip space; 0 if
// the draw has no motion of its own. material.frag reads them as texels.
using MotionRows = std::array<glm::vec4, 3>;
// Returns the rows of each draw.
std::vector<MotionRows> motionRows(const std::vector<Draw>& draws);

// Matches the block Draw of object.glsl.
struct DrawConstants {
    std::array<glm::vec4, 3> toShading;
    std::array<glm::vec4, 3> normalToShading;
    uint32_t seed;
    float handedness;
    uint32_t index;
    uint32_t firstIndex; // first index of the mesh
    uint32_t firstVertex;
};
static_assert(sizeof(DrawConstants) <= 128, "Vulkan promises no more push constants than this.");

// `index` is the index in the frame's list of draws.
DrawConstants drawConstants(const Scene& scene, const Draw& draw, uint32_t index);

struct Variant {
    bool isMasked = false;
    bool isDoubleSided = false;
    bool isMirrored = false;
    uint32_t features = 0; // materialFeatures()
    MotionOutput motion = MotionOutput::None;

    auto operator<=>(const Variant&) const = default;
};

Variant variantOf(const Scene& scene, const Draw& draw);

} // namespace harness
