// glTF 2.0 (.gltf, .glb) to Scene.
#pragma once

#include "scene/scene.h"

#include <filesystem>

namespace harness {

// Throws std::runtime_error with one sentence naming the file where it cannot be read.
Scene loadGltf(const std::filesystem::path& path);

// A built-in name or a path.
Scene loadScene(const std::string& nameOrPath);

} // namespace harness
