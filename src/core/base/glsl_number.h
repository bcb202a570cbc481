// Numbers in GLSL text.
#pragma once

#include <string>

namespace agaa {

// Returns a float literal. The decimal point does not depend on the process's locale.
std::string glslNumber(float value);

} // namespace agaa
