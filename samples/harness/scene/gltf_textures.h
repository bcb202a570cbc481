// Textures of glTF materials.
#pragma once

#include "scene/gltf_reader.h"

#include <map>
#include <span>
#include <tuple>

namespace harness {

// Creates a texture for each image, sampler and colour space that materials use.
class TextureTable {
public:
    explicit TextureTable(GltfReader& reader) : reader_(reader) {}

    // Returns -1 if the material has no texture, or one whose only image has the format of an optional extension.
    int find(int index, bool srgb);

private:
    std::span<const unsigned char> encoded(const tinygltf::Image& image, const std::string& name) const;
    Texture decode(int index) const;

    GltfReader& reader_;
    std::map<std::tuple<int, Wrap, Wrap, TextureFilters, bool>, int> known_;
};

TextureCoordinates coordinatesOf(const GltfReader& reader, int set, const tinygltf::ExtensionMap& extensions);

} // namespace harness
