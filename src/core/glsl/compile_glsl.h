// Compilation of GLSL to SPIR-V at run time, for passes with GLSL of the host.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace agaa {

// The compiler keeps its tables of built-in functions while there are objects of this class. They take longer to make
// than most passes to compile.
class GlslCompilerUse {
public:
    GlslCompilerUse();
    ~GlslCompilerUse();
    GlslCompilerUse(const GlslCompilerUse&) = delete;
    GlslCompilerUse& operator=(const GlslCompilerUse&) = delete;
};

// Throws AGAA_ERROR_INVALID_ARGUMENT with the compiler's first message. `what` begins the sentence.
std::vector<uint32_t> compileCompute(const std::string& text, const char* what);

} // namespace agaa
