// Compilation of GLSL to SPIR-V at run time, for passes with GLSL of the host.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace agaa {

// Throws AGAA_ERROR_INVALID_ARGUMENT with the compiler's first message. `what` begins the sentence.
std::vector<uint32_t> compileCompute(const std::string& text, const char* what);

} // namespace agaa
