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

// Throws AGAA_ERROR_INVALID_ARGUMENT like compileCompute() if this fragment shader does not compile.
void checkFragment(const std::string& text, const char* what);

// Returns the text with its conditions decided and its macros expanded. Throws
// AGAA_ERROR_INVALID_ARGUMENT with the first message.
std::string preprocess(const std::string& text);

} // namespace agaa
