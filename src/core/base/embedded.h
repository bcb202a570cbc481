// Shaders built into the library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace agaa {

// Returns whether the library has SPIR-V of a pass permutation.
bool hasSpirv(std::string_view name);
// Decompresses the SPIR-V of a pass permutation. Returns nothing if there is none of this name.
std::vector<uint32_t> embeddedSpirv(std::string_view name);
// Returns whether the SPIR-V of a pass permutation uses its specialisation constant of this id.
bool readsConstant(std::string_view name, uint32_t specId);
// Returns the GLSL text of a path below src/shaders, or nothing if there is none.
std::string_view embeddedGlsl(std::string_view path);

} // namespace agaa
