// Assembles the library's GLSL. The compilers that hosts and the library use do not support #include.
#pragma once

#include "core/plan/plan.h"

#include <set>
#include <string>

namespace agaa {

// Appends a file below src/shaders. Its #include lines are replaced by the files, each file once. hostCode replaces the
// line that includes "host-code".
void appendGlsl(std::string& out, const std::string& path, std::set<std::string>& seen,
                const std::string& hostCode = {});

// Appends a text whose #include lines name such files.
void appendGlslText(std::string& out, const std::string& text, std::set<std::string>& seen);

// Returns the coverage functions of alpha-masked surfaces, for shaders of the host (agaaGetCoverageGlsl).
std::string coverageGlsl();

// Returns the text of a compute pass for Vulkan, with specialisation constants. Throws Error if the host's text is too
// deep for compilers (expression_depth.h).
std::string passGlsl(const Pass& pass);
// Returns the text for OpenGL, with the values of the pass's constants. Throws the same error.
std::string passGlslForOpenGl(const Pass& pass, uint32_t glslVersion);

} // namespace agaa
