// The bytes of a glTF file. They are checked before tinygltf parses them, because it trusts chunk sizes, recurses into
// nested values, and fails at the consequences of an extension before it reports the extension.
#pragma once

#include "scene/shortened.h"

#include <tiny_gltf.h>

#include <array>
#include <filesystem>
#include <string>

namespace harness {

inline constexpr std::array knownExtensions{"KHR_lights_punctual", "KHR_materials_clearcoat",
                                            "KHR_materials_emissive_strength", "KHR_mesh_quantization",
                                            "KHR_texture_transform"};

// Parses a .gltf or .glb file; its first bytes decide which. Images are not decoded: Image::image holds the bytes of an
// image file, and is empty if the image lies in a buffer or its file is missing or empty. Throws std::runtime_error
// without the name of the file.
tinygltf::Model readGltfModel(const std::filesystem::path& path);

} // namespace harness
