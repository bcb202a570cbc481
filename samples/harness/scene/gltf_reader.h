// Parts of the glTF loader; see gltf.h.
#pragma once

#include "scene/scene.h"

#include <tiny_gltf.h>

#include <stdexcept>
#include <string>

namespace harness {

struct GltfReader {
    const tinygltf::Model& model;
    std::string file; // named in errors
    Scene& scene;

    [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(file + ": " + what + "."); }
    // Returns the element of a list at an index of a file.
    template <typename T> const T& at(const std::vector<T>& list, int index, const char* what) const {
        if (index < 0 || size_t(index) >= list.size())
            fail(std::string("an index of ") + what + " is out of range");
        return list[size_t(index)];
    }
};

void readMaterials(GltfReader& reader);
// Creates one Mesh per primitive. first[i] is the first Mesh of glTF mesh i, first.back() is their number.
std::vector<uint32_t> readMeshes(GltfReader& reader);

} // namespace harness
