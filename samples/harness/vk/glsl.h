// GLSL to SPIR-V at run time: the SDK hands its declarations over as text.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace harness::vk {

enum class ShaderStage { Vertex, Geometry, Fragment, Compute };

// Throws std::runtime_error with the compiler's messages and the lines they name. `name` is told in
// the error.
std::vector<uint32_t> compileGlsl(ShaderStage stage, const std::string& source,
                                  const std::string& name);

// A text of shaders/ that needs nothing of the SDK's, with what comes before it.
std::string vulkanText(const char* body);

} // namespace harness::vk
