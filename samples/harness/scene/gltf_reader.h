// Parts of the glTF loader; see gltf.h.
#pragma once

#include "scene/scene.h"

#include <tiny_gltf.h>

#include <stdexcept>
#include <string>

namespace harness {

struct GltfReader {
    const tinygltf::Model& model;
    std::string file; // for error sentences
    Scene& scene;

    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(file + ": " + what + ".");
    }
    // An element of a list by a file's index.
    template <typename T>
    const T& at(const std::vector<T>& list, int index, const char* what) const {
        if (index < 0 || size_t(index) >= list.size())
            fail(std::string("an index of ") + what + " is out of range");
        return list[size_t(index)];
    }
};

void readMaterials(GltfReader& reader);
// One Mesh per primitive; first[i] is the first Mesh of glTF mesh i, first.back() their number.
std::vector<uint32_t> readMeshes(GltfReader& reader);

} // namespace harness
