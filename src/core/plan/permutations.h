// The switches that compute passes are compiled for (src/shaders/tables/permutations.inc).
#pragma once

#include <string_view>

namespace agaa {

// The shader's file below src/shaders. Throws Error for a shader that the table does not have.
const char* passFile(std::string_view shader);
// The shader's file below src/shaders. Throws Error for a shader that the table does not have.
const char* passFile(std::string_view shader);
// Letters of a pass, in the order of permutations' names. Throws Error for a shader that the table does not have.
std::string_view passSwitches(std::string_view shader);
const char* switchMacro(char letter);

} // namespace agaa
