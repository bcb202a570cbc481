// Seeded procedural scenes after the papers' test scenes. Equal names give equal bytes on every run.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace harness {

struct BuiltinScene {
    std::string_view name;
    std::string_view stresses;
};

const std::vector<BuiltinScene>& builtinScenes();
// Returns the small scenes of numerically hard cases, whose names begin with "hard-".
const std::vector<BuiltinScene>& hardScenes();

// Returns a scene of the lists, or "blades-N" with N in [0, 100000], whose density grows with N. Empty for other names.
std::optional<Scene> makeBuiltinScene(std::string_view name);

} // namespace harness
