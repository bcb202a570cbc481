// Shaders built into the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace agaa {

// SPIR-V of a pass permutation by name, empty where there is none.
std::span<const uint32_t> embeddedSpirv(std::string_view name);
// Whether SPIR-V uses its specialisation constant of this id.
bool readsConstant(std::span<const uint32_t> spirv, uint32_t specId);
// GLSL text by path below src/shaders, empty where there is none.
std::string_view embeddedGlsl(std::string_view path);

} // namespace agaa
