// GLSL of the library put together: compilers that hosts and the library use know no #include.
#pragma once

#include "core/plan/plan.h"

#include <set>
#include <string>

namespace agaa {

// Appends a file below src/shaders with its #include lines replaced, each file once. hostCode stands
// where the text includes "host-code".
void appendGlsl(std::string& out, const std::string& path, std::set<std::string>& seen,
                const std::string& hostCode = {});

// The same of a text whose #include lines name such files.
void appendGlslText(std::string& out, const std::string& text, std::set<std::string>& seen);

// The coverage of alpha-masked surfaces, for shaders of the host's own (agaaGetCoverageGlsl).
std::string coverageGlsl();

// The whole text of a compute pass, for Vulkan. Its specialisation constants stay.
std::string passGlsl(const Pass& pass);
// For OpenGL: the pass's constants are written into it.
std::string passGlslForOpenGl(const Pass& pass, uint32_t glslVersion);

} // namespace agaa
