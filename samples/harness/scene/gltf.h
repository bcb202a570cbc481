// Loads glTF 2.0 (.gltf, .glb) into a Scene: triangles in their default shape and pose, core materials, perspective and
// orthographic cameras, and the extensions of gltf_document.h. Scene::dropped names the other features of a file, and a
// file that requires another extension is refused. docs/sample-engine.md lists the limits.
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
