// The sample engine's scene: geometry, materials, textures, lights and cameras in memory. Positions are in world space,
// as double or float; the renderer converts them to camera-relative ones.
#pragma once

#include <compare>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace harness {

// A vertex in the layout of the vertex buffer. tangent.w is the handedness (+1 or -1).
struct Vertex {
    glm::vec3 position{0};
    glm::vec3 normal{0, 1, 0};
    glm::vec4 tangent{1, 0, 0, 1};
    glm::vec2 uv{0};
    glm::u8vec4 color{255, 255, 255, 255}; // linear, multiplied with the base colour
};

// A range of Scene::indices drawn with one material. Indices are relative to firstVertex.
struct Mesh {
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    uint32_t firstVertex = 0;
    uint32_t vertexCount = 0;
    uint32_t material = 0;
    glm::vec3 boundsMin{0}; // object space
    glm::vec3 boundsMax{0};
};

struct Instance {
    uint32_t mesh = 0;
    glm::dmat4 transform{1}; // object to world
};

enum class AlphaMode { Opaque, Mask, Blend };

// Metallic-roughness material of glTF 2.0. Texture members index Scene::textures, -1 for none.
struct Material {
    std::string name;
    glm::vec4 baseColor{1};
    float metallic = 0;
    float roughness = 1; // perceptual, alpha = roughness^2
    glm::vec3 emissive{0};
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5f;
    bool doubleSided = false;
    float normalScale = 1;
    bool hasClearCoat = false;  // KHR_materials_clearcoat, at full strength
    int baseColorTexture = -1;  // sRGB
    int normalTexture = -1;     // linear, tangent space
    int metalRoughTexture = -1; // linear, G roughness, B metallic
    int emissiveTexture = -1;   // sRGB
};

enum class Wrap { Repeat, Mirror, Clamp };

enum class Filter { Linear, Nearest };
enum class MipFilter { Linear, Nearest, None };

struct TextureFilters {
    Filter magnify = Filter::Linear;
    Filter minify = Filter::Linear; // within a mip level
    MipFilter mips = MipFilter::Linear;

    auto operator<=>(const TextureFilters&) const = default;
};

struct Sampling {
    Wrap wrapU = Wrap::Repeat;
    Wrap wrapV = Wrap::Repeat;
    TextureFilters filters = {};

    auto operator<=>(const Sampling&) const = default;
};

// RGBA8, rows from top to bottom, no mip levels (the renderer makes them).
struct Texture {
    std::string name;
    uint32_t width = 0;
    uint32_t height = 0;
    bool srgb = false;
    Wrap wrapU = Wrap::Repeat;
    Wrap wrapV = Wrap::Repeat;
    std::vector<uint8_t> rgba;
    TextureFilters filters = {};

    Sampling sampling() const { return {wrapU, wrapV, filters}; }
};

enum class LightType { Directional, Point, Spot };

struct Light {
    LightType type = LightType::Point;
    glm::dvec3 position{0};         // point, spot
    glm::dvec3 direction{0, -1, 0}; // directional, spot: unit direction of the light
    glm::vec3 color{1};             // irradiance (directional) or intensity (point, spot), linear
    float range = 0;                // world units, 0: infinite
    float radius = 0.01f;           // world units; within it, the inverse-square law stops
    float innerCone = 0;            // radians, half angle
    float outerCone = 0.7853982f;
    bool castsShadow = false;
};

struct Camera {
    std::string name;
    glm::dvec3 eye{0, 0, 1};
    glm::dvec3 target{0};
    glm::dvec3 up{0, 1, 0};
    double fovDegrees = 60; // vertical
    double height = 0;      // world units that an orthographic view covers vertically; 0: perspective
};

struct Scene {
    std::string name;
    std::string stresses; // one line: the difficulty of the scene
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
    std::vector<Mesh> meshes;
    std::vector<Instance> instances;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    std::vector<Light> lights;
    std::vector<Camera> cameras;
    std::vector<std::string> dropped; // one sentence for each feature of a file that the scene does not have
    glm::dvec3 boundsMin{0};          // world space, over all instances, without stray vertices
    glm::dvec3 boundsMax{0};

    uint64_t placedTriangles() const;
};

// Recomputes Mesh bounds and the scene's bounds from its vertices and instances. The scene's bounds exclude vertices
// and instances that are 2^24 times as far from the others as those are from each other. Mesh bounds include all
// vertices.
void updateBounds(Scene& scene);

// Returns a camera that frames the whole scene from a three-quarter view, for any size and position.
Camera defaultCamera(const Scene& scene);

// Returns the lights of the papers: one shadowed directional light and 16 ranged point lights without shadow. A fixed
// seed places them inside the scene's bounds around the camera's target.
std::vector<Light> defaultLights(const Scene& scene, const Camera& camera);
// Returns the same lights around the target of the scene's first camera, or of the default camera.
std::vector<Light> defaultLights(const Scene& scene);
// Returns point lights, and a spot light for every three of them, with short ranges around the camera's target.
std::vector<Light> smallLights(const Scene& scene, const Camera& camera, uint32_t count);

} // namespace harness
