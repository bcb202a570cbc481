// Parts of the glTF loader; see gltf.h.
#pragma once

#include "scene/scene.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

namespace harness {

// Limits of the loader. Numbers and counts beyond them occur in damaged files only.
constexpr double largestNumber = 1e15; // its square is a float
constexpr uint32_t mostVertices = 1u << 26;
constexpr uint32_t mostIndices = 1u << 28;

// Converts a finite number of a file, which may exceed the range of float.
inline float finiteFloat(double value) { return float(std::clamp(value, -largestNumber, largestNumber)); }

// The texture coordinates of a material: a set of the vertices, scaled, rotated and moved (KHR_texture_transform).
struct TextureCoordinates {
    int set = 0;
    glm::dvec2 scale{1};
    double rotation = 0; // radians
    glm::dvec2 offset{0};

    bool operator==(const TextureCoordinates&) const = default;
    glm::vec2 of(const glm::dvec2& uv) const;
};

struct GltfReader {
    const tinygltf::Model& model;
    std::string file; // named in errors
    Scene& scene;
    std::vector<TextureCoordinates> coordinates = {};       // one for each element of Scene::materials
    std::vector<std::optional<glm::dmat4>> transforms = {}; // node to world; none outside of the scene

    [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(file + ": " + what + "."); }
    // Records a feature of the file that the scene does not have, once.
    void drop(const std::string& what) const;
    // Returns the element of a list at an index of a file.
    template <typename T> const T& at(const std::vector<T>& list, int index, const char* what) const {
        if (index < 0 || size_t(index) >= list.size())
            fail(std::string("an index of ") + what + " is out of range");
        return list[size_t(index)];
    }
};

// Drops the features that the file's lists show; the other parts drop those that they meet.
void dropUnsupportedFeatures(const GltfReader& reader);
void readMaterials(GltfReader& reader);
// Returns the matrices that move vertices from a mesh to the world, one for each joint.
std::vector<glm::dmat4> jointMatrices(const GltfReader& reader, int skin);

} // namespace harness
