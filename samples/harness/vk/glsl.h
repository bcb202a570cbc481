// GLSL to SPIR-V at run time, because the SDK's declarations are text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace harness::vk {

enum class ShaderStage { Vertex, Geometry, Fragment, Compute };

// Throws std::runtime_error with `name`, the compiler's messages and the lines that they name.
std::vector<uint32_t> compileGlsl(ShaderStage stage, const std::string& source, const std::string& name);

// Returns a shader of shaders/ that needs no SDK text, with its prefix.
std::string vulkanText(const char* body);

} // namespace harness::vk
