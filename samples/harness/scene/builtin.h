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

// Empty where the name is not a built-in scene.
std::optional<Scene> makeBuiltinScene(std::string_view name);

} // namespace harness
