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

// A scene of the list, or "blades-N", N in [0, 100000]: a ladder of densities. Empty where the name is neither.
std::optional<Scene> makeBuiltinScene(std::string_view name);

} // namespace harness
