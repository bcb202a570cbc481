// Shaders built into the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace agaa {

// Returns the SPIR-V of a pass permutation, or nothing if there is none of this name.
std::span<const uint32_t> embeddedSpirv(std::string_view name);
// Returns whether the SPIR-V uses its specialisation constant of this id.
bool readsConstant(std::span<const uint32_t> spirv, uint32_t specId);
// Returns the GLSL text of a path below src/shaders, or nothing if there is none.
std::string_view embeddedGlsl(std::string_view path);

} // namespace agaa
