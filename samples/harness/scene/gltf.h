// Loads glTF 2.0 (.gltf, .glb) into a Scene: triangles with the first set of texture coordinates, core materials with
// KHR_materials_emissive_strength, KHR_lights_punctual, perspective cameras. It skips animation, skins and morph
// targets, and refuses a file that requires any other extension.
#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace harness {

// Throws std::runtime_error with one sentence that names the file if it cannot be read.
Scene loadGltf(const std::filesystem::path& path);

// Returns whether a name ends in .gltf or .glb, in any case.
bool isGltfName(const std::filesystem::path& path);

// Loads a built-in scene by name, or a file by path.
Scene loadScene(const std::string& nameOrPath);

} // namespace harness
