// glTF 2.0 (.gltf, .glb) to Scene: triangles with the first set of texture coordinates, core
// materials with KHR_materials_emissive_strength, KHR_lights_punctual, perspective cameras.
// Animation, skins and morph targets are left out; a file that requires any other extension is
// refused.
#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace harness {

// Throws std::runtime_error with one sentence naming the file where it cannot be read.
Scene loadGltf(const std::filesystem::path& path);

// A built-in name or a path.
Scene loadScene(const std::string& nameOrPath);

} // namespace harness
